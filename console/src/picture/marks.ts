// Boxes that a person marks in a picture: [u, v, width, height] in whole pixels of the picture, always within it.
import type { Size } from '../regions/shapes';
import type { Box, Pixel } from '../types';

/** The sides of the box that a tap gives, and of the smallest one. */
export const tap_px = 24;
export const least_px = 4;

// A range of at least `least` pixels within 0 to `end`.
function fitted(start: number, length: number, end: number): [number, number] {
  const whole = Math.min(end, Math.max(least_px, Math.round(length)));
  return [Math.max(0, Math.min(end - whole, Math.round(start))), whole];
}

function box(size: Size, u: number, v: number, width: number, height: number): Box {
  const [left, columns] = fitted(u, width, size.width);
  const [top, rows] = fitted(v, height, size.height);
  return [left, top, columns, rows];
}

/** The box around a point that was tapped. */
export function boxAround({ u, v }: Pixel, size: Size, side = tap_px): Box {
  return box(size, u + 0.5 - side / 2, v + 0.5 - side / 2, side, side);
}

/** The box with two opposite corners, in any order. */
export function boxBetween(a: Pixel, b: Pixel, size: Size): Box {
  const limit = (value: number, end: number) => Math.max(0, Math.min(end - 1, Math.round(value)));
  const [u1, u2] = [limit(Math.min(a.u, b.u), size.width), limit(Math.max(a.u, b.u), size.width)];
  const [v1, v2] = [limit(Math.min(a.v, b.v), size.height), limit(Math.max(a.v, b.v), size.height)];
  return box(size, u1, v1, u2 - u1 + 1, v2 - v1 + 1);
}

/** The box, moved as far as the picture reaches. */
export function movedBox([u, v, width, height]: Box, size: Size, du: number, dv: number): Box {
  return box(size, u + du, v + dv, width, height);
}

/** The box with its right and lower sides moved, as far as the picture reaches. */
export function resizedBox([u, v, width, height]: Box, size: Size, du: number, dv: number): Box {
  return [u, v, Math.min(size.width - u, Math.max(least_px, width + du)), Math.min(size.height - v, Math.max(least_px, height + dv))];
}

/** A box in the middle of the part that is shown, a sixth as high. */
export function boxInMiddle([u, v, width, height]: Box, size: Size): Box {
  return boxAround({ u: u + width / 2 - 0.5, v: v + height / 2 - 0.5 }, size, Math.max(least_px, Math.round(height / 6)));
}
