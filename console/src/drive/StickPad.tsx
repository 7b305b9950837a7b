// A stick on the screen, for a gloved thumb or a mouse: hold and pull; letting go stops.
import { useRef, useState } from 'preact/hooks';
import { words } from '../words/words';
import { sticks } from './sticks';

const dead = 0.12;

export function StickPad({ enabled }: { enabled: boolean }) {
  const pad = useRef<HTMLDivElement>(null);
  const [at, setAt] = useState({ x: 0, y: 0 });

  const pull = (event: PointerEvent) => {
    const box = pad.current?.getBoundingClientRect();
    if (!box) return;
    const x = ((event.clientX - box.left) / box.width) * 2 - 1;
    const y = ((event.clientY - box.top) / box.height) * 2 - 1;
    const length = Math.hypot(x, y);
    const scale = length > 1 ? 1 / length : 1;
    setAt({ x: x * scale, y: y * scale });
    const speed = length < dead ? 0 : 1;
    sticks.setTouch({ pan: -x * scale * speed, tilt: -y * scale * speed });
  };
  const letGo = () => {
    setAt({ x: 0, y: 0 });
    sticks.setTouch({ pan: 0, tilt: 0 });
  };

  return (
    <div
      ref={pad}
      class={`stick ${enabled ? '' : 'disabled'}`}
      role="application"
      aria-label={words.drive.stick}
      aria-disabled={!enabled}
      data-testid="stick"
      onPointerDown={(event) => {
        if (!enabled) return;
        (event.currentTarget as HTMLElement).setPointerCapture(event.pointerId);
        pull(event);
      }}
      onPointerMove={(event) => {
        if ((event.currentTarget as HTMLElement).hasPointerCapture(event.pointerId)) pull(event);
      }}
      onPointerUp={letGo}
      onPointerCancel={letGo}
      onLostPointerCapture={letGo}
    >
      <span class="stick-arrow up">▲</span>
      <span class="stick-arrow down">▼</span>
      <span class="stick-arrow left">◀</span>
      <span class="stick-arrow right">▶</span>
      <span class="stick-knob" style={{ left: `${50 + 36 * at.x}%`, top: `${50 + 36 * at.y}%` }} />
    </div>
  );
}
