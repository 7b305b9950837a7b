// The points that were tapped, and the distances measured there.
import type { Measurement, Pixel } from '../types';

interface Props {
  width: number;
  height: number;
  points: Pixel[];
  measured: Measurement | null;
}

function sayDistance(measured: Measurement, i: number): string {
  const point = measured.points[i];
  return point ? `${point.distance_m.toFixed(3)} m` : 'no depth measured here';
}

function Label({ u, v, width, text }: { u: number; v: number; width: number; text: string }) {
  const onRight = u < width * 0.7;
  return (
    <text x={onRight ? u + 14 : u - 14} y={v - 10} text-anchor={onRight ? 'start' : 'end'} class="measure-text">
      {text}
    </text>
  );
}

export function MeasureMarks({ width, height, points, measured }: Props) {
  const [a, b] = points;
  const length = measured?.length_mm;
  return (
    <svg class="overlay" viewBox={`0 0 ${width} ${height}`} aria-live="polite" data-testid="measure">
      {a && b && <line x1={a.u} y1={a.v} x2={b.u} y2={b.v} class="measure-line" />}
      {points.map(({ u, v }) => (
        <g key={`${u} ${v}`} class="measure-mark">
          <circle cx={u} cy={v} r="7" />
          <path d={`M${u - 12} ${v}h24M${u} ${v - 12}v24`} />
        </g>
      ))}
      {measured && a && !b && <Label u={a.u} v={a.v} width={width} text={sayDistance(measured, 0)} />}
      {measured && a && b && (
        <Label
          u={(a.u + b.u) / 2}
          v={(a.v + b.v) / 2}
          width={width}
          text={length === undefined ? 'no depth measured at one end' : `${length.toFixed(1)} mm`}
        />
      )}
    </svg>
  );
}
