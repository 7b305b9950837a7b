// How the 3D view turns about the point at its middle. z is up.
export type Xyz = [number, number, number];

/** How near to straight above or below the view may come: beyond, it would turn over. */
const least_rad = 0.05;

/**
 * @param from_target from the point in the middle to the camera
 * @param left_rad    how far the camera goes to the left around it
 * @param up_rad      how far it rises above it, as far as straight above
 */
export function turned([x, y, z]: Xyz, left_rad: number, up_rad: number): Xyz {
  const distance = Math.hypot(x, y, z);
  const azimuth = Math.atan2(y, x) - left_rad;
  const from_top = Math.acos(z / distance) - up_rad;
  const polar = Math.min(Math.PI - least_rad, Math.max(least_rad, from_top));
  const level = distance * Math.sin(polar);
  return [level * Math.cos(azimuth), level * Math.sin(azimuth), distance * Math.cos(polar)];
}

/** The same direction from another distance, within limits. */
export function brought([x, y, z]: Xyz, times: number, [least_m, most_m]: [number, number]): Xyz {
  const distance = Math.hypot(x, y, z);
  const scale = Math.min(most_m, Math.max(least_m, distance * times)) / distance;
  return [scale * x, scale * y, scale * z];
}
