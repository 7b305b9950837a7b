// Sliders of quantities that span orders of magnitude: equal steps are equal ratios.
import type { Range } from '../types';

/** @return 0 at the least value, 1 at the greatest, and within them for values beyond */
export function positionOf(value: number, [least, greatest]: Range): number {
  const position = Math.log(value / least) / Math.log(greatest / least);
  return Math.min(1, Math.max(0, position));
}

/** The value at a position from 0 to 1, the inverse of `positionOf`; exact at both ends. */
export function valueAt(position: number, [least, greatest]: Range): number {
  if (position >= 1) return greatest;
  return least * (greatest / least) ** Math.max(0, position);
}
