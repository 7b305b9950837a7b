// Changes regions by keyboard.
import type { Inspection, Polygon } from '../types';
import { removeRegion, replaceRegion } from './region_state';
import { moved, resized, type Size } from './shapes';

const directions: Record<string, [number, number]> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};
const step_px = 8;

/** A key that changes a region does not turn the camera as well, which arrow keys do elsewhere. */
export function changeByKey(event: KeyboardEvent, inspection: Inspection, at: number, region: Polygon, size: Size): void {
  const direction = directions[event.key];
  const removes = event.key === 'Delete' || event.key === 'Backspace';
  if ((!direction && !removes) || event.ctrlKey || event.altKey || event.metaKey) return;
  event.preventDefault();
  event.stopPropagation();
  if (!direction) return removeRegion(inspection, at);
  const change = event.shiftKey ? resized : moved;
  replaceRegion(inspection, at, change(region, size, step_px * direction[0], step_px * direction[1]));
}
