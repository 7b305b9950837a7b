// The texts of the console in the language that is shown, with its numbers and times.
import { en, type Words } from './en';

/** Read it while drawing: another language replaces it. */
export let words: Words = en;

let locale = 'en';

/** @param tag the language as browsers name it, for example de-AT, for numbers and times */
export function setWords(next: Words, tag: string): void {
  words = next;
  locale = tag;
}

/** Without a separator of thousands, which is the decimal point of another language. */
export function decimal(value: number, places: number): string {
  return new Intl.NumberFormat(locale, { minimumFractionDigits: places, maximumFractionDigits: places, useGrouping: false }).format(value);
}

export function timeText(iso: string): string {
  return new Date(iso).toLocaleString(locale, { dateStyle: 'medium', timeStyle: 'short' });
}

export function clockText(iso: string): string {
  return new Date(iso).toLocaleTimeString(locale);
}

/** @param month 2026-01 */
export function monthText(month: string): string {
  return new Date(`${month}-01T00:00:00Z`).toLocaleDateString(locale, { month: 'short', year: 'numeric', timeZone: 'UTC' });
}

export function percentText(share: number): string {
  return `${Math.round(100 * share)} %`;
}

/** With its first letter in upper case. */
export function sentence(text: string): string {
  return text.charAt(0).toUpperCase() + text.slice(1);
}
