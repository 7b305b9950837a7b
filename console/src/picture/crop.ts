// The part of a picture that a close-up of a box shows.
import type { Size } from '../regions/shapes';
import type { Box } from '../types';

/** How much larger than in the picture a close-up shows its part at most: beyond it, there is nothing more to see. */
export const most_times = 4;
/** A part is at least this many times as wide and as high as its box, so that its surroundings are seen. */
const surroundings = 2;
const shape = 4 / 3;

/**
 * The part around a box, in pixels of the picture and within it; 4 : 3 unless the picture is too small for that.
 * @param least_px the width of the smallest part
 */
export function cropAround([u, v, width, height]: Box, size: Size, least_px: number): Box {
  const wanted = Math.ceil(Math.max(least_px, surroundings * width, surroundings * height * shape));
  const columns = Math.min(size.width, wanted);
  const rows = Math.min(size.height, Math.ceil(wanted / shape));
  const start = (middle: number, length: number, end: number) => Math.max(0, Math.min(end - length, Math.round(middle - length / 2)));
  return [start(u + width / 2, columns, size.width), start(v + height / 2, rows, size.height), columns, rows];
}
