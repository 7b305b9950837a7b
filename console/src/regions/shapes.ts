// Polygons in a picture, in its pixels: the centre of the first pixel is (0, 0).
import type { Corner, Polygon } from '../types';

export interface Size {
  width: number;
  height: number;
}

interface Bounds {
  left: number;
  top: number;
  right: number;
  bottom: number;
}

/** Regions that are smaller than this cannot be seen or selected any more. */
export const least_px = 4;

function clamp(value: number, low: number, high: number): number {
  return Math.max(low, Math.min(high, value));
}

function rounded(value: number): number {
  return Math.round(10 * value) / 10;
}

export function within(size: Size, [u, v]: Corner): Corner {
  return [rounded(clamp(u, -0.5, size.width - 0.5)), rounded(clamp(v, -0.5, size.height - 0.5))];
}

export function boundsOf(polygon: Polygon): Bounds {
  const us = polygon.map(([u]) => u);
  const vs = polygon.map(([, v]) => v);
  return { left: Math.min(...us), top: Math.min(...vs), right: Math.max(...us), bottom: Math.max(...vs) };
}

/** Whether a polygon contains a point, by the number of edges that a ray to the right crosses, as on the server. */
export function contains(polygon: Polygon, [u, v]: Corner): boolean {
  let inside = false;
  polygon.forEach(([u1, v1], i) => {
    const [u2, v2] = polygon[(i + 1) % polygon.length]!;
    if (v1 > v !== v2 > v && u < u1 + ((u2 - u1) * (v - v1)) / (v2 - v1)) inside = !inside;
  });
  return inside;
}

/** The topmost region at a point, or -1. */
export function regionAt(regions: Polygon[], place: Corner): number {
  let top = -1;
  regions.forEach((region, i) => {
    if (contains(region, place)) top = i;
  });
  return top;
}

/** How much of a picture lies in regions, 0 to 1; where regions overlap, it counts once. */
export function coveredShare(regions: Polygon[], size: Size): number {
  const covered = new Uint8Array(size.width * size.height);
  let count = 0;
  for (const region of regions) {
    const { left, top, right, bottom } = boundsOf(region);
    for (let v = Math.max(0, Math.ceil(top)); v <= Math.min(size.height - 1, bottom); ++v)
      for (let u = Math.max(0, Math.ceil(left)); u <= Math.min(size.width - 1, right); ++u) {
        const at = v * size.width + u;
        if (covered[at] || !contains(region, [u, v])) continue;
        covered[at] = 1;
        ++count;
      }
  }
  return count / covered.length;
}

/** The rectangle between two opposite corners, or null if it is too small to be intended. */
export function rectangle(size: Size, from: Corner, to: Corner): Polygon | null {
  const [u1, v1] = within(size, from);
  const [u2, v2] = within(size, to);
  if (Math.abs(u1 - u2) < least_px || Math.abs(v1 - v2) < least_px) return null;
  return [[u1, v1], [u2, v1], [u2, v2], [u1, v2]];
}

/** A rectangle in the middle of the picture, a quarter as wide and as high. */
export function middleRectangle({ width, height }: Size): Polygon {
  const [left, top, right, bottom] = [0.375 * width, 0.375 * height, 0.625 * width, 0.625 * height].map((edge) => Math.round(edge) - 0.5) as [number, number, number, number];
  return [[left, top], [right, top], [right, bottom], [left, bottom]];
}

/** The polygon, moved, but not out of the picture. */
export function moved(polygon: Polygon, size: Size, du: number, dv: number): Polygon {
  const { left, top, right, bottom } = boundsOf(polygon);
  const shift_u = clamp(du, -0.5 - left, size.width - 0.5 - right);
  const shift_v = clamp(dv, -0.5 - top, size.height - 0.5 - bottom);
  return polygon.map(([u, v]) => within(size, [u + shift_u, v + shift_v]));
}

/** The polygon, resized at its right and lower sides, but not beyond the picture and not to nothing. */
export function resized(polygon: Polygon, size: Size, du: number, dv: number): Polygon {
  const { left, top, right, bottom } = boundsOf(polygon);
  const scale = (low: number, high: number, change: number, end: number) =>
    high > low ? clamp(high - low + change, Math.min(least_px, high - low), end - low) / (high - low) : 1;
  const scale_u = scale(left, right, du, size.width - 0.5);
  const scale_v = scale(top, bottom, dv, size.height - 0.5);
  return polygon.map(([u, v]) => within(size, [left + (u - left) * scale_u, top + (v - top) * scale_v]));
}

/** Whether two points are so near to each other that the same one was meant. */
export function isNear([u1, v1]: Corner, [u2, v2]: Corner, reach_px: number): boolean {
  return Math.hypot(u1 - u2, v1 - v2) <= reach_px;
}
