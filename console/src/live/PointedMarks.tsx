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
          <text x={mark.from.x * size.width} y={Math.min(mark.from.y, mark.to.y) * size.height - 26 * px} text-anchor="middle" font-size={20 * px} stroke-width={5 * px}>
            {mark.name || words.page.somebody}
          </text>
        </g>
      ))}
    </svg>
  );
}
