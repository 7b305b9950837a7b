// What the check before a capture found, in the language that is shown.
import type { ReadinessItem, ReadinessValues } from '../types';
import type { Figures } from '../words/en';
import { decimal, percentText, words } from '../words/words';

const places: Record<Exclude<keyof ReadinessValues, 'measured'>, number> = {
  width_px: 0,
  height_px: 0,
  rate_hz: 1,
  repeated_frames: 0,
  frames: 0,
  drift_mm: 2,
  duration_s: 0,
  pan_deg: 1,
  tilt_deg: 1,
  free_gb: 1,
  least_free_gb: 1,
};

function figuresOf(values: ReadinessValues): Figures {
  const shown = Object.entries(places).map(([name, digits]) => [name, decimal(values[name as keyof ReadinessValues] ?? NaN, digits)]);
  return { ...Object.fromEntries(shown), measured: percentText(values.measured ?? NaN) } as Figures;
}

/** The sentences of an item, or null where the server has no more than an error message, which is in English. */
export function readinessText({ code, values }: ReadinessItem): string | null {
  const sentences: Partial<Record<ReadinessItem['code'], (figures: Figures) => string>> = words.readiness.sentences;
  return sentences[code]?.(figuresOf(values)) ?? null;
}

export function readinessName(name: string): string {
  const names: Record<string, string> = words.readiness.names;
  return names[name] ?? name;
}
