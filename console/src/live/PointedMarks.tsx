// What people point at in the live picture: a ring, an arrow or a circle, with the name of the person.
import { useEffect } from 'preact/hooks';
import { link } from '../link/live_link';
import type { Frame } from '../picture/ZoomPicture';
import type { Size } from '../regions/shapes';
import { useStore } from '../store';
import type { Pointed, Stream } from '../types';
import { words } from '../words/words';

/** How long a mark is shown. */
export const shown_ms = 6000;

function Shape({ mark, size, px }: { mark: Pointed; size: Size; px: number }) {
  const [u1, v1] = [mark.from.x * size.width, mark.from.y * size.height];
  const [u2, v2] = [mark.to.x * size.width, mark.to.y * size.height];
  if (mark.shape === 'tap') return <circle cx={u1} cy={v1} r={22 * px} />;
  if (mark.shape === 'circle') return <ellipse cx={(u1 + u2) / 2} cy={(v1 + v2) / 2} rx={Math.max(8 * px, Math.abs(u2 - u1) / 2)} ry={Math.max(8 * px, Math.abs(v2 - v1) / 2)} />;
  const angle = Math.atan2(v2 - v1, u2 - u1);
  const wing = (side: number) => `L${u2 - 20 * px * Math.cos(angle + side)} ${v2 - 20 * px * Math.sin(angle + side)}`;
  return <path d={`M${u1} ${v1}L${u2} ${v2}${wing(0.5)}M${u2} ${v2}${wing(-0.5)}`} />;
}

// Above the shape, or below it where the picture that is shown ends; never beyond its sides.
function Name({ mark, size, frame }: { mark: Pointed; size: Size; frame: Frame }) {
  const [left, top, width] = frame.shown;
  const px = frame.screen_px;
  const u = size.width * (mark.shape === 'circle' ? (mark.from.x + mark.to.x) / 2 : mark.from.x);
  const [highest, lowest] = [size.height * Math.min(mark.from.y, mark.to.y), size.height * Math.max(mark.from.y, mark.to.y)];
  const hasRoom = highest - 50 * px > top;
  const sides = 0.15 * width;
  const anchor = u < left + sides ? 'start' : u > left + width - sides ? 'end' : 'middle';
  return (
    <text x={u} y={hasRoom ? highest - 28 * px : lowest + 48 * px} text-anchor={anchor} font-size={20 * px} stroke-width={5 * px}>
      {mark.name || words.page.somebody}
    </text>
  );
}

interface Props {
  stream: Stream;
  frame: Frame;
  size: Size;
}

export function PointedMarks({ stream, frame, size }: Props) {
  const marks = useStore(link.pointed);
  const px = frame.screen_px;
  useEffect(() => {
    const [oldest] = marks;
    if (!oldest) return;
    const timer = setTimeout(() => (link.pointed.value = link.pointed.value.filter((mark) => mark !== oldest)), shown_ms);
    return () => clearTimeout(timer);
  }, [marks[0]]);
  const here = marks.filter((mark) => mark.stream === stream);
  return (
    <svg class="overlay" viewBox={frame.viewBox} aria-live="polite" data-testid="pointed">
      {here.map((mark, i) => (
        <g key={i} class="pointed">
          <g class="halo">
            <Shape mark={mark} size={size} px={px} />
          </g>
          <Shape mark={mark} size={size} px={px} />
          <Name mark={mark} size={size} frame={frame} />
        </g>
      ))}
    </svg>
  );
}
