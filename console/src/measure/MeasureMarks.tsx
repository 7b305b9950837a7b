// The points that were selected in a picture, and what was measured there.
import './measure.css';
import type { Frame } from '../picture/ZoomPicture';
import type { Pixel } from '../types';
import type { Measuring } from './measuring';
import { labelText } from './result';

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

// Where the middle of the frame is, for selecting it.
function Middle({ frame: { shown: [u, v, width, height], screen_px } }: { frame: Frame }) {
  const arm = 18 * screen_px;
  return <path class="measure-middle" d={`M${u + width / 2 - arm} ${v + height / 2}h${2 * arm}M${u + width / 2} ${v + height / 2 - arm}v${2 * arm}`} />;
}

export function MeasureMarks({ frame, measuring }: { frame: Frame; measuring: Measuring }) {
  const { points, surface, measured, active } = measuring;
  const arm = 12 * frame.screen_px;
  const [a, b] = points;
  const last = points.at(-1);
  const between = a && b && { u: (a.u + b.u) / 2, v: (a.v + b.v) / 2 };
  const label = between || last;
  return (
    <svg class="overlay" viewBox={frame.viewBox} aria-live="polite" data-testid="measure">
      {active && <Middle frame={frame} />}
      {surface && <rect class="measure-surface" x={surface[0] - 0.5} y={surface[1] - 0.5} width={surface[2]} height={surface[3]} data-testid="surface" />}
      {a && b && <line x1={a.u} y1={a.v} x2={b.u} y2={b.v} class="measure-line" />}
      {points.map(({ u, v }, i) => (
        <g key={i} class="measure-mark">
          <circle cx={u} cy={v} r={7 * frame.screen_px} />
          <path d={`M${u - arm} ${v}h${2 * arm}M${u} ${v - arm}v${2 * arm}`} />
        </g>
      ))}
      {measured && label && !measured.profile && <Label u={label.u} v={label.v} frame={frame} text={labelText(measured)} />}
    </svg>
  );
}

/** The pixel in the middle of the part of a picture that is shown. */
export function middleOf([u, v, width, height]: readonly number[]): Pixel {
  return { u: u! + width! / 2 - 0.5, v: v! + height! / 2 - 0.5 };
}
