// All connected controllers: the one that was moved last turns the camera, and each of them can stop it.
import { type Deflection, isNeutral, neutral } from './deflection';
import type { Pad } from './gamepads';
import { layoutOf, type TaughtMappings } from './pad_mapping';
import { PadWatch } from './pad_watch';

export type PadState = 'ready' | 'unmapped' | 'restless';

export interface PadReport {
  slot: number;
  id: string;
  standard: boolean;
  taught: boolean;
  state: PadState;
}

export interface PadSettings {
  dead_zone: number;
  taught: TaughtMappings;
  /** The slot of the controller that is being taught, which does not turn the camera meanwhile. */
  teaching: number | null;
}

interface Watched {
  slot: number;
  /** Differs for another controller in the same slot and for another mapping, which are watched separately. */
  key: string;
  watch: PadWatch;
  stopIsPressed: boolean;
}

export interface Reading {
  /** The deflection of the controller that turns the camera. */
  deflection: Deflection;
  /** Whether a stop button was pressed since the last reading. */
  stop: boolean;
  reports: PadReport[];
  /** The id of the controller that was moved last, or of another one if that is no longer connected; empty if there is none. */
  id: string;
}

export class Controllers {
  private watched: Watched[] = [];
  private moved: number | null = null;

  /** @param disarmed whether the robot waits for all sticks to be let go */
  read(pads: Pad[], now_ms: number, settings: PadSettings, disarmed: boolean): Reading {
    const before = this.watched;
    this.watched = [];
    let stop = false;
    const reports = pads.map((pad) => {
      const report = { slot: pad.slot, id: pad.id, standard: pad.standard, taught: pad.id in settings.taught };
      const layout = layoutOf(pad, settings.taught);
      if (!layout) return { ...report, state: 'unmapped' as const };
      const key = JSON.stringify([pad.slot, pad.id, layout]);
      const known = before.find((one) => one.key === key);
      const watch = known?.watch ?? new PadWatch(layout);
      watch.observe(pad, now_ms, settings.dead_zone, disarmed);
      const stopIsPressed = pad.buttons[layout.stop] ?? false;
      stop ||= stopIsPressed && !known?.stopIsPressed;
      this.watched.push({ slot: pad.slot, key, watch, stopIsPressed });
      return { ...report, state: watch.restless ? ('restless' as const) : ('ready' as const) };
    });
    const deflection = this.follow(settings.teaching);
    const named =
      reports.find(({ slot }) => slot === this.moved) ?? reports.find(({ state }) => state !== 'unmapped') ?? reports[0];
    return { deflection, stop, reports, id: named?.id ?? '' };
  }

  private follow(teaching: number | null): Deflection {
    const deflected = this.watched.filter(({ slot, watch }) => slot !== teaching && !isNeutral(watch.deflection));
    const [latest] = deflected.sort((one, other) => other.watch.moved_ms - one.watch.moved_ms);
    if (latest) this.moved = latest.slot;
    return latest?.watch.deflection ?? neutral;
  }
}
