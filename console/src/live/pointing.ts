// Points at something in the live picture, for all consoles.
import { link } from '../link/live_link';
import { useMarking, type Line, type Marking } from '../picture/marking';
import type { Size } from '../regions/shapes';
import type { Box, PictureShare, PointingShape, Stream } from '../types';

function shareOf(u: number, v: number, { width, height }: Size): PictureShare {
  const limit = (share: number) => Math.max(0, Math.min(1, share));
  return { x: limit((u + 0.5) / width), y: limit((v + 0.5) / height) };
}

/** An arrow along the finger's way, or, without one, a spot; a circle within the box. */
export function pointAt(stream: Stream, shape: PointingShape, [u, v, width, height]: Box, line: Line | undefined, size: Size): void {
  if (shape === 'circle') {
    link.point({ stream, shape, from: shareOf(u - 0.5, v - 0.5, size), to: shareOf(u + width - 0.5, v + height - 0.5, size) });
  } else if (shape === 'arrow' && line) {
    const [from, to] = line;
    link.point({ stream, shape, from: shareOf(from.u, from.v, size), to: shareOf(to.u, to.v, size) });
  } else {
    const middle = shareOf(u + width / 2 - 0.5, v + height / 2 - 0.5, size);
    link.point({ stream, shape: 'tap', from: middle, to: middle });
  }
}

/** Drawing for all consoles; it goes on until it is left. */
export function usePointing(stream: Stream, shape: PointingShape, size: Size): Marking {
  const pointing: Marking = useMarking((box, line) => {
    pointAt(stream, shape, box, line, size);
    pointing.begin();
  });
  return pointing;
}
