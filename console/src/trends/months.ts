// Months and scales of the charts.
import type { Trend, Trends } from '../types';

/** A month with its trend; null without an inspection. */
export interface ShownMonth {
  month: string;
  trend: Trend | null;
}

// Months since the year 0; NaN for a text that is no month.
function numberOf(month: string): number {
  const [, year, number] = /^(\d{4})-(\d{2})$/.exec(month) ?? [];
  return 12 * Number(year) + Number(number) - 1;
}

function monthOf(number: number): string {
  return `${String(Math.floor(number / 12)).padStart(4, '0')}-${String((number % 12) + 1).padStart(2, '0')}`;
}

/** The months up to the last one that has a trend, from the first one, at most `most`. */
export function monthsOf(all: Trends, zone: string | null, most: number): ShownMonth[] {
  const trends = zone === null ? all.months : all.zone_months.filter((one) => one.zone === zone);
  const known = new Map(trends.map((trend) => [numberOf(trend.month), trend]));
  const last = Math.max(...known.keys());
  const first = Math.max(Math.min(...known.keys()), last - most + 1);
  const months: ShownMonth[] = [];
  for (let number = first; number <= last; ++number) months.push({ month: monthOf(number), trend: known.get(number) ?? null });
  return months;
}

/** The smallest of 1, 2, 5, 10, 20, 50, ... that is not below a value. */
export function roundedUp(value: number): number {
  const power = 10 ** Math.floor(Math.log10(Math.max(value, 1e-6)));
  return [1, 2, 5, 10].map((step) => step * power).find((step) => step >= value * (1 - 1e-9)) ?? 10 * power;
}
