// Which part of a picture its frame shows. Frame and picture have the same shape, and positions in both are
// fractions of their width and height, so that a zoom holds for every size of the screen and of the picture.
import type { Size } from '../regions/shapes';
import type { Box } from '../types';

export interface Point {
  x: number;
  y: number;
}

export interface Zoom {
  /** How many times larger the picture is than its frame, 1 to `most`. */
  scale: number;
  /** What of the picture is at the left and upper edges of the frame, 0 to 1 - 1 / scale. */
  left: number;
  top: number;
}

export const whole: Zoom = { scale: 1, left: 0, top: 0 };
export const most = 10;
/** How much a button, a key or a double tap enlarges. */
export const step = 1.5;
export const double_tap = 3;

const middle: Point = { x: 0.5, y: 0.5 };

function clamp(value: number, low: number, high: number): number {
  return Math.max(low, Math.min(high, value));
}

// The picture never leaves its frame.
function within({ scale, left, top }: Zoom): Zoom {
  const end = 1 - 1 / scale;
  return { scale, left: clamp(left, 0, end), top: clamp(top, 0, end) };
}

/** What of the picture is at a point of the frame. */
export function inPicture({ scale, left, top }: Zoom, { x, y }: Point): Point {
  return { x: left + x / scale, y: top + y / scale };
}

/** Moves what is at `from` in the frame to `to`, and enlarges it, as far as the limits allow. */
export function pulled(zoom: Zoom, from: Point, to: Point, times = 1): Zoom {
  const scale = clamp(zoom.scale * times, 1, most);
  const { x, y } = inPicture(zoom, from);
  return within({ scale, left: x - to.x / scale, top: y - to.y / scale });
}

/** Enlarges the picture about a point of the frame, which keeps what it shows unless an edge is reached. */
export function zoomedAbout(zoom: Zoom, at: Point, times: number): Zoom {
  return pulled(zoom, at, at, times);
}

export function zoomed(zoom: Zoom, times: number): Zoom {
  return zoomedAbout(zoom, middle, times);
}

/** Moves the frame over the picture, in fractions of the frame. */
export function panned(zoom: Zoom, dx: number, dy: number): Zoom {
  return pulled(zoom, { x: dx, y: dy }, { x: 0, y: 0 });
}

/** The part of a picture that is shown, in its pixels: [u, v, width, height], not rounded. */
export function shownPart({ scale, left, top }: Zoom, { width, height }: Size): Box {
  return [left * width, top * height, width / scale, height / scale];
}

/** A box in the middle of the frame, in pixels of the picture, as far as the edges allow. */
export function centredOn([u, v, width, height]: Box, size: Size, scale: number): Zoom {
  const x = (u + width / 2) / size.width;
  const y = (v + height / 2) / size.height;
  return within({ scale, left: x - 0.5 / scale, top: y - 0.5 / scale });
}

/** A box and its surroundings: a third of the frame, unless it is so large that it would be enlarged by less than three. */
export function closeTo(box: Box, size: Size): Zoom {
  const share = (part: number) => Math.min((part * size.width) / box[2], (part * size.height) / box[3]);
  return centredOn(box, size, clamp(Math.min(Math.max(share(1 / 3), 3), share(0.8)), 1, most));
}
