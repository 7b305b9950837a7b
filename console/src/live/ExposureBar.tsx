// The exposure of the infrared imagers, in place of the bar above the live picture.
import { useLayoutEffect, useRef, useState } from 'preact/hooks';
import { Choice } from '../Choice';
import { attempt } from '../inspection/inspections';
import { api } from '../link/api';
import type { ExposureRequest, ExposureStatus, Range } from '../types';
import { decimal, words } from '../words/words';
import { positionOf, valueAt } from './exposure';

interface SliderProps {
  name: string;
  label: string;
  value: number;
  range: Range;
  text: string;
  disabled: boolean;
  onValue: (value: number) => void;
}

function Slider({ name, label, value, range, text, disabled, onValue }: SliderProps) {
  return (
    <label class="exposure-slider">
      <span>
        {label} <strong>{text}</strong>
      </span>
      <input
        type="range"
        min={0}
        max={1}
        step={0.01}
        value={positionOf(value, range)}
        disabled={disabled}
        aria-valuetext={text}
        data-testid={`exposure-${name}`}
        onInput={(event) => onValue(valueAt(event.currentTarget.valueAsNumber, range))}
        // The arrow keys turn the camera again once the slider is let go.
        onPointerUp={(event) => event.currentTarget.blur()}
      />
    </label>
  );
}

// Sends the newest request, one at a time, so that a slider does not queue requests.
function useNewest(): (request: ExposureRequest) => void {
  const waiting = useRef<ExposureRequest | null>(null);
  const busy = useRef(false);
  return (request) => {
    waiting.current = request;
    if (busy.current) return;
    busy.current = true;
    void attempt(async () => {
      while (waiting.current) {
        const next = waiting.current;
        waiting.current = null;
        await api.setExposure(next);
      }
    }).finally(() => (busy.current = false));
  };
}

/** @param exposure as the camera states it now */
export function ExposureBar({ exposure, onClose }: { exposure: ExposureStatus; onClose: () => void }) {
  const [chosen, setChosen] = useState<Required<ExposureRequest>>(exposure);
  const send = useNewest();
  useLayoutEffect(() => {
    const press = (event: KeyboardEvent) => event.key === 'Escape' && onClose();
    window.addEventListener('keydown', press);
    return () => window.removeEventListener('keydown', press);
  }, []);
  // A fixed exposure begins with what the camera chose by itself.
  const { time_us, gain } = chosen.automatic ? exposure : chosen;
  const choose = (change: Partial<ExposureRequest>) => {
    const { automatic } = { ...chosen, ...change };
    const next = { automatic, time_us, gain, ...change };
    setChosen(next);
    send(next);
  };
  const modes: ['automatic' | 'fixed', string][] = [
    ['automatic', words.live.automatic],
    ['fixed', words.live.fixed],
  ];
  return (
    <div class="view-bar exposure-bar" data-testid="exposure-bar">
      <Choice label={words.live.exposure} name="exposure" options={modes} value={chosen.automatic ? 'automatic' : 'fixed'} onPick={(mode) => choose({ automatic: mode === 'automatic' })} />
      <Slider
        name="time"
        label={words.live.exposureTime}
        value={time_us}
        range={exposure.time_range_us}
        text={`${decimal(time_us / 1000, 2)} ms`}
        disabled={chosen.automatic}
        onValue={(value) => choose({ time_us: value })}
      />
      <Slider name="gain" label={words.live.gain} value={gain} range={exposure.gain_range} text={decimal(gain, 0)} disabled={chosen.automatic} onValue={(value) => choose({ gain: value })} />
      <button type="button" data-testid="exposure-close" onClick={onClose}>
        {words.page.close}
      </button>
      <span class="hint">{words.live.exposureHelp}</span>
    </div>
  );
}
