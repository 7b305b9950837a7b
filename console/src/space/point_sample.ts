// A random order of the map's points, and where most of a sample of them lies.

const enough = 5000;

/** A pseudo-random order of the numbers from 0, so that the first points are a fair sample of all. */
export function shuffled(count: number): Uint32Array {
  const order = Uint32Array.from({ length: count }, (_, i) => i);
  let state = 1;
  for (let i = count - 1; i > 0; --i) {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    // Of a number of this sequence, only the high bits are random.
    const k = Math.floor((state / 2 ** 32) * (i + 1));
    const swap = order[i]!;
    order[i] = order[k]!;
    order[k] = swap;
  }
  return order;
}

/** The value that a share of the values does not exceed; sorts them. 0 if there are none. */
export function quantile(values: Float32Array, share: number): number {
  return values.sort()[Math.floor(share * (values.length - 1))] ?? 0;
}

// A few thousand points in random order are enough, and quantiles of them are not influenced by outliers.
function sampleOf(xyz: Float32Array, value: (at: number) => number): Float32Array {
  return Float32Array.from({ length: Math.min(enough, xyz.length / 3) }, (_, i) => value(3 * i));
}

/** The middle along an axis of points in random order. */
export function middle(xyz: Float32Array, axis: number): number {
  const values = sampleOf(xyz, (at) => xyz[at + axis]!);
  return (quantile(values, 0.05) + quantile(values, 0.95)) / 2;
}

/** The distance from a centre within which most of the points in random order lie. */
export function reach_m(xyz: Float32Array, [x, y, z]: [number, number, number]): number {
  const distances = sampleOf(xyz, (at) => Math.hypot(xyz[at]! - x, xyz[at + 1]! - y, xyz[at + 2]! - z));
  return Math.max(0.05, quantile(distances, 0.95));
}
