// The deflection of a stick, -1 to 1 on each axis; pan is positive to the left, tilt upwards.
export interface Deflection {
  pan: number;
  tilt: number;
}

export const neutral: Deflection = { pan: 0, tilt: 0 };

export function isNeutral({ pan, tilt }: Deflection): boolean {
  return pan === 0 && tilt === 0;
}

/** The sum of deflections, limited to full deflection. */
export function sumOf(deflections: Deflection[]): Deflection {
  const sum = (axis: keyof Deflection) =>
    Math.max(-1, Math.min(1, deflections.reduce((total, deflection) => total + deflection[axis], 0)));
  return { pan: sum('pan'), tilt: sum('tilt') };
}
