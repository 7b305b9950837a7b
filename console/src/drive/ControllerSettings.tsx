// The connected controllers, the teaching of their mappings, and the dead zone of their sticks.
import { useState } from 'preact/hooks';
import { useStore } from '../store';
import { Rich } from '../words/Rich';
import { percentText, words } from '../words/words';
import type { PadReport } from './controllers';
import { nameOf } from './gamepads';
import { dead_zone_range, padMemory } from './pad_memory';
import { sticks } from './sticks';
import { TeachController } from './TeachController';

function ConnectedPad({ pad }: { pad: PadReport }) {
  const [isTeaching, setTeaching] = useState(false);
  const name = nameOf(pad.id);
  const { teach, teachAgain, teachIt, teachItAgain, forget, forgetIt, states } = words.drive;
  return (
    <li class="controller" data-testid={`controller-${pad.slot}`}>
      <div>
        <strong>{name}</strong>
        {!isTeaching && <p class={pad.state === 'ready' ? 'good' : 'warn'}>{states[pad.state]}</p>}
      </div>
      {isTeaching ? (
        <TeachController slot={pad.slot} id={pad.id} onEnd={() => setTeaching(false)} />
      ) : (
        !pad.standard && (
          <div class="controller-actions">
            <button
              type="button"
              class={pad.taught ? '' : 'primary'}
              aria-label={pad.taught ? teachItAgain(name) : teachIt(name)}
              data-testid="teach-begin"
              onClick={() => setTeaching(true)}
            >
              {pad.taught ? teachAgain : teach}
            </button>
            {pad.taught && (
              <button type="button" aria-label={forgetIt(name)} data-testid="teach-forget" onClick={() => padMemory.forget(pad.id)}>
                {forget}
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
        <Rich text={words.drive.deadZone(percentText(deadZone))} />
      </span>
      <input
        type="range"
        min={dead_zone_range.least}
        max={dead_zone_range.most}
        step={0.01}
        value={deadZone}
        aria-valuetext={percentText(deadZone)}
        data-testid="dead-zone"
        onInput={(event) => (padMemory.deadZone.value = event.currentTarget.valueAsNumber)}
        // The arrow keys turn the camera again once the slider is let go.
        onPointerUp={(event) => event.currentTarget.blur()}
      />
      <small>{words.drive.deadZoneHelp}</small>
    </label>
  );
}

export function ControllerSettings({ onClose }: { onClose: () => void }) {
  const pads = useStore(sticks.pads);
  return (
    <div class="card controller-settings" role="region" aria-label={words.drive.controller} data-testid="controller-settings">
      <div class="controller-head">
        <h2>{words.drive.controller}</h2>
        <button type="button" onClick={onClose}>
          {words.page.close}
        </button>
      </div>
      {pads.length === 0 && <p class="hint">{words.drive.noController}</p>}
      {pads.length > 1 && <p class="hint">{words.drive.lastMoved}</p>}
      <ul class="list">
        {pads.map((pad) => (
          <ConnectedPad key={`${pad.slot} ${pad.id}`} pad={pad} />
        ))}
      </ul>
      <DeadZone />
    </div>
  );
}
