// Teaches the mapping of a controller by asking for one push or press after another.
import { useEffect, useRef, useState } from 'preact/hooks';
import { words } from '../words/words';
import { connectedPads, nameOf } from './gamepads';
import { padMemory } from './pad_memory';
import { sticks } from './sticks';
import { Teaching, type TeachingStep } from './teaching';

const period_ms = 50;

interface Props {
  slot: number;
  id: string;
  onEnd: () => void;
}

export function TeachController({ slot, id, onEnd }: Props) {
  const [step, setStep] = useState<TeachingStep>('rest');
  const cancel = useRef<HTMLButtonElement>(null);

  useEffect(() => {
    const teaching = new Teaching();
    sticks.teaching.value = slot;
    cancel.current?.focus();
    const timer = setInterval(() => {
      const pad = connectedPads().find((one) => one.slot === slot && one.id === id);
      if (!pad) return onEnd();
      teaching.observe(pad, performance.now());
      setStep(teaching.step);
      if (!teaching.mapping || teaching.step !== 'done') return;
      padMemory.teach(id, teaching.mapping);
      onEnd();
    }, period_ms);
    return () => {
      clearInterval(timer);
      sticks.teaching.value = null;
    };
  }, [slot, id]);

  return (
    <div class="note" role="group" aria-label={words.drive.teachIt(nameOf(id))} data-testid="teach">
      <p class="teach-step" role="status" data-testid="teach-step">
        {words.drive.instructions[step]}
      </p>
      <p class="hint">{words.drive.meanwhile}</p>
      <button type="button" ref={cancel} data-testid="teach-cancel" onClick={onEnd}>
        {words.page.cancel}
      </button>
    </div>
  );
}
