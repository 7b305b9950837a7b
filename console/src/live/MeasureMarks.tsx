// The points that were tapped, and the distances measured there.
import type { Frame } from '../picture/ZoomPicture';
import type { Measurement, Pixel } from '../types';

interface Props {
  frame: Frame;
  points: Pixel[];
  measured: Measurement | null;
}

function sayDistance(measured: Measurement, i: number): string {
  const point = measured.points[i];
  return point ? `${point.distance_m.toFixed(3)} m` : 'no depth measured here';
}

function Label({ u, v, frame, text }: { u: number; v: number; frame: Frame; text: string }) {
  const px = frame.screen_px;
  const [left, , width] = frame.shown;
  const onRight = u < left + width * 0.7;
  return (
    <text x={onRight ? u + 14 * px : u - 14 * px} y={v - 12 * px} text-anchor={onRight ? 'start' : 'end'} class="measure-text" font-size={22 * px} stroke-width={5 * px}>
      {text}
    </text>
  );
}

export function MeasureMarks({ frame, points, measured }: Props) {
  const [a, b] = points;
  const length = measured?.length_mm;
  const arm = 12 * frame.screen_px;
  return (
    <svg class="overlay" viewBox={frame.viewBox} aria-live="polite" data-testid="measure">
      {a && b && <line x1={a.u} y1={a.v} x2={b.u} y2={b.v} class="measure-line" />}
      {points.map(({ u, v }) => (
        <g key={`${u} ${v}`} class="measure-mark">
          <circle cx={u} cy={v} r={7 * frame.screen_px} />
          <path d={`M${u - arm} ${v}h${2 * arm}M${u} ${v - arm}v${2 * arm}`} />
        </g>
      ))}
      {measured && a && !b && <Label u={a.u} v={a.v} frame={frame} text={sayDistance(measured, 0)} />}
      {measured && a && b && (
        <Label u={(a.u + b.u) / 2} v={(a.v + b.v) / 2} frame={frame} text={length === undefined ? 'no depth measured at one end' : `${length.toFixed(1)} mm`} />
      )}
    </svg>
  );
}
