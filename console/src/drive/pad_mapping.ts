// Which axes and buttons of a controller turn the camera, and which stops it.
import type { Pad } from './gamepads';

/** The deflection of slow movements, where 1 is full deflection. */
export const slow = 0.3;

interface Use {
  at: number;
  turns: 'pan' | 'tilt';
  /** The deflection of the camera when the axis is at 1 or the button is pressed. */
  scale: number;
}

export interface Layout {
  axes: Use[];
  buttons: Use[];
  stop: number;
}

export interface Direction {
  axis: number;
  sign: 1 | -1;
}

/** The taught mapping of a controller: the axes for right and up, and the stop button. */
export interface TaughtMapping {
  right: Direction;
  up: Direction;
  stop: number;
}

export type TaughtMappings = Record<string, TaughtMapping>;

/** The left stick drives, the right stick and the cross drive slowly; the right-hand button stops. */
const standard: Layout = {
  axes: [
    { at: 0, turns: 'pan', scale: -1 },
    { at: 1, turns: 'tilt', scale: -1 },
    { at: 2, turns: 'pan', scale: -slow },
    { at: 3, turns: 'tilt', scale: -slow },
  ],
  buttons: [
    { at: 12, turns: 'tilt', scale: slow },
    { at: 13, turns: 'tilt', scale: -slow },
    { at: 14, turns: 'pan', scale: slow },
    { at: 15, turns: 'pan', scale: -slow },
  ],
  stop: 1,
};

/** The layout of a controller; null if its mapping is neither standard nor taught. */
export function layoutOf(pad: Pad, taught: TaughtMappings): Layout | null {
  if (pad.standard) return standard;
  const mapping = taught[pad.id];
  if (!mapping) return null;
  return {
    axes: [
      { at: mapping.right.axis, turns: 'pan', scale: -mapping.right.sign },
      { at: mapping.up.axis, turns: 'tilt', scale: mapping.up.sign },
    ],
    buttons: [],
    stop: mapping.stop,
  };
}

function isIndex(value: unknown): boolean {
  return Number.isInteger(value) && (value as number) >= 0;
}

/** Whether a stored value is a mapping: an older version of the page may have stored something else. */
export function isTaughtMapping(value: unknown): value is TaughtMapping {
  const { right, up, stop } = (value ?? {}) as Partial<TaughtMapping>;
  const isDirection = (one: Direction | undefined) => isIndex(one?.axis) && Math.abs(one?.sign ?? 0) === 1;
  return isDirection(right) && isDirection(up) && right?.axis !== up?.axis && isIndex(stop);
}
