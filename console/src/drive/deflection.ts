// How far a stick is deflected, between -1 and 1 each; pan is positive to the left, tilt upwards.
export interface Deflection {
  pan: number;
  tilt: number;
}

export const neutral: Deflection = { pan: 0, tilt: 0 };

export function isNeutral({ pan, tilt }: Deflection): boolean {
  return pan === 0 && tilt === 0;
}

/** Adds deflections up, within full deflection. */
export function sumOf(deflections: Deflection[]): Deflection {
  const sum = (axis: keyof Deflection) =>
    Math.max(-1, Math.min(1, deflections.reduce((total, deflection) => total + deflection[axis], 0)));
  return { pan: sum('pan'), tilt: sum('tilt') };
}
