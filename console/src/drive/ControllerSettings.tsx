// The connected controllers, the teaching of their mappings, and the dead zone of their sticks.
import { useState } from 'preact/hooks';
import { useStore } from '../store';
import type { PadReport } from './controllers';
import { nameOf } from './gamepads';
import { dead_zone_range, padMemory } from './pad_memory';
import { stateWords } from './pad_words';
import { sticks } from './sticks';
import { TeachController } from './TeachController';

function ConnectedPad({ pad }: { pad: PadReport }) {
  const [isTeaching, setTeaching] = useState(false);
  const name = nameOf(pad.id);
  const teach = pad.taught ? 'Teach again' : 'Teach';
  return (
    <li class="controller" data-testid={`controller-${pad.slot}`}>
      <div>
        <strong>{name}</strong>
        {!isTeaching && <p class={pad.state === 'ready' ? 'good' : 'warn'}>{stateWords[pad.state]}</p>}
      </div>
      {isTeaching ? (
        <TeachController slot={pad.slot} id={pad.id} onEnd={() => setTeaching(false)} />
      ) : (
        !pad.standard && (
          <div class="controller-actions">
            <button
              type="button"
              class={pad.taught ? '' : 'primary'}
              aria-label={`${teach} ${name}`}
              data-testid="teach-begin"
              onClick={() => setTeaching(true)}
            >
              {teach}
            </button>
            {pad.taught && (
              <button type="button" aria-label={`Forget ${name}`} data-testid="teach-forget" onClick={() => padMemory.forget(pad.id)}>
                Forget
              </button>
            )}
          </div>
        )
      )}
    </li>
  );
}

function DeadZone() {
  const deadZone = useStore(padMemory.deadZone);
  return (
    <label class="field">
      <span>
        Dead zone <strong>{Math.round(100 * deadZone)} %</strong>
      </span>
      <input
        type="range"
        min={dead_zone_range.least}
        max={dead_zone_range.most}
        step={0.01}
        value={deadZone}
        aria-valuetext={`${Math.round(100 * deadZone)} %`}
        data-testid="dead-zone"
        onInput={(event) => (padMemory.deadZone.value = event.currentTarget.valueAsNumber)}
        // The arrow keys turn the camera again once the slider is let go.
        onPointerUp={(event) => event.currentTarget.blur()}
      />
      <small>How far a stick must be pushed before the camera turns.</small>
    </label>
  );
}

export function ControllerSettings({ onClose }: { onClose: () => void }) {
  const pads = useStore(sticks.pads);
  return (
    <div class="card controller-settings" role="region" aria-label="Controller" data-testid="controller-settings">
      <div class="controller-head">
        <h2>Controller</h2>
        <button type="button" onClick={onClose}>
          Close
        </button>
      </div>
      {pads.length === 0 && <p class="hint">No controller is connected. Plug one in, then press one of its buttons.</p>}
      {pads.length > 1 && <p class="hint">The controller that was moved last turns the camera.</p>}
      <ul class="list">
        {pads.map((pad) => (
          <ConnectedPad key={`${pad.slot} ${pad.id}`} pad={pad} />
        ))}
      </ul>
      <DeadZone />
    </div>
  );
}
