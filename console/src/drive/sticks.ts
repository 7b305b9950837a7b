// All inputs that drive the camera, combined into one deflection. Hold to run: an input that is let go or lost
// reads as neutral, and all of them do while the page is hidden or does not have the focus.
import { link } from '../link/live_link';
import { Store } from '../store';
import { Controllers, type PadReport } from './controllers';
import { type Deflection, isNeutral, neutral, sumOf } from './deflection';
import { connectedPads } from './gamepads';
import { padMemory } from './pad_memory';
import { slow } from './pad_mapping';

const period_ms = 50;

const keys: Record<string, Deflection> = {
  ArrowLeft: { pan: 1, tilt: 0 },
  KeyA: { pan: 1, tilt: 0 },
  ArrowRight: { pan: -1, tilt: 0 },
  KeyD: { pan: -1, tilt: 0 },
  ArrowUp: { pan: 0, tilt: 1 },
  KeyW: { pan: 0, tilt: 1 },
  ArrowDown: { pan: 0, tilt: -1 },
  KeyS: { pan: 0, tilt: -1 },
};

function isTyping(target: EventTarget | null): boolean {
  return target instanceof HTMLElement && target.closest('input, textarea, select, [role="slider"]') !== null;
}

/** After a stop the robot waits for everything to be let go. */
function isDisarmed(): boolean {
  return link.status.value?.robot?.armed === false;
}

class Sticks {
  /** The current deflection of all inputs together. */
  readonly held = new Store<Deflection>(neutral);
  /** The id of the game controller that was moved last, or of one that is connected, or empty. */
  readonly controller = new Store<string>('');

  /** All controllers that are connected. */
  readonly pads = new Store<PadReport[]>([]);

  /** The slot of the controller that is being taught, which does not turn the camera meanwhile; null if there is none. */
  readonly teaching = new Store<number | null>(null);

  /** Whether the user tried to drive without having the controls. */
  readonly denied = new Store(false);

  private readonly pressed = new Set<string>();
  private touch: Deflection = neutral;
  private readonly controllers = new Controllers();
  private sentNeutral = true;

  start(): void {
    window.addEventListener('keydown', (event) => this.press(event));
    window.addEventListener('keyup', (event) => {
      this.pressed.delete(event.code);
      this.tick();
    });
    for (const gone of ['blur', 'pagehide']) window.addEventListener(gone, () => this.letGo());
    document.addEventListener('visibilitychange', () => this.letGo());
    setInterval(() => this.tick(), period_ms);
  }

  /** Sets the deflection of the stick on the screen; called whenever it moves. */
  setTouch(deflection: Deflection): void {
    this.touch = deflection;
    this.tick();
  }

  letGo(): void {
    this.pressed.clear();
    this.touch = neutral;
    this.tick();
  }

  private press(event: KeyboardEvent): void {
    if (event.code === 'Escape') {
      link.stop();
      return;
    }
    if (!(event.code in keys) || isTyping(event.target) || event.ctrlKey || event.altKey || event.metaKey) return;
    if (!link.lease.value.yours) {
      this.denied.value = true;
      return;
    }
    event.preventDefault();
    if (event.repeat) return;
    this.pressed.add(event.code);
    this.slowly = event.shiftKey;
    this.tick();
  }
  private slowly = false;

  private tick(): void {
    const now = this.read();
    this.held.value = now.pan === this.held.value.pan && now.tilt === this.held.value.tilt ? this.held.value : now;
    if (!link.lease.value.yours || link.state.value !== 'open') return;
    if (isNeutral(now) && this.sentNeutral && !isDisarmed()) return;
    link.drive(now.pan, now.tilt);
    this.sentNeutral = isNeutral(now);
  }

  private read(): Deflection {
    const all = [this.fromControllers(), this.fromKeys(), this.touch];
    if (document.visibilityState !== 'visible' || !document.hasFocus()) return neutral;
    return sumOf(all);
  }

  private fromKeys(): Deflection {
    const scale = this.slowly ? slow : 1;
    let pan = 0;
    let tilt = 0;
    for (const code of this.pressed) {
      pan += keys[code]?.pan ?? 0;
      tilt += keys[code]?.tilt ?? 0;
    }
    return { pan: pan * scale, tilt: tilt * scale };
  }

  private fromControllers(): Deflection {
    const settings = { dead_zone: padMemory.deadZone.value, taught: padMemory.taught.value, teaching: this.teaching.value };
    const awaited = link.lease.value.yours && isDisarmed();
    const { deflection, stop, reports, id } = this.controllers.read(connectedPads(), performance.now(), settings, awaited);
    if (stop) link.stop();
    this.controller.value = id;
    if (JSON.stringify(reports) !== JSON.stringify(this.pads.value)) this.pads.value = reports;
    return deflection;
  }
}

export const sticks = new Sticks();
