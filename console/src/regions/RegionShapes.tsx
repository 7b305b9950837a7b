// Regions over a picture: hatched, outlined and numbered, so that they do not depend on colour alone.
import { useId } from 'preact/hooks';
import type { Polygon } from '../types';
import { boundsOf, type Size } from './shapes';

function pointsOf(polygon: Polygon): string {
  return polygon.map(([u, v]) => `${u},${v}`).join(' ');
}

/** The view box of a drawing over a picture, in the picture's pixels. */
export function viewBoxOf({ width, height }: Size): string {
  return `-0.5 -0.5 ${width} ${height}`;
}

export function Hatching({ id, size }: { id: string; size: Size }) {
  const step = size.width / 60;
  return (
    <defs>
      <pattern id={id} width={step} height={step} patternUnits="userSpaceOnUse" patternTransform="rotate(45)">
        <rect width={step} height={step} fill="var(--stripe-dark)" fill-opacity="0.45" />
        <rect width={step / 2} height={step} fill="var(--stripe)" fill-opacity="0.65" />
      </pattern>
    </defs>
  );
}

export function RegionShape({ region, number, size, hatching }: { region: Polygon; number: number; size: Size; hatching: string }) {
  const { left, top, right, bottom } = boundsOf(region);
  const points = pointsOf(region);
  return (
    <>
      <polygon class="region-halo" points={points} />
      <polygon class="region-outline" points={points} fill={`url(#${hatching})`} />
      <text class="region-number" x={(left + right) / 2} y={(top + bottom) / 2} font-size={size.width / 34} text-anchor="middle" dominant-baseline="central">
        {number}
      </text>
    </>
  );
}

/** A drawing of regions that cannot be changed. */
export function StillRegions({ regions, size }: { regions: Polygon[]; size: Size }) {
  const hatching = useId();
  return (
    <svg class="overlay" viewBox={viewBoxOf(size)} aria-hidden="true">
      <Hatching id={hatching} size={size} />
      {regions.map((region, i) => (
        <RegionShape key={i} region={region} number={i + 1} size={size} hatching={hatching} />
      ))}
    </svg>
  );
}
