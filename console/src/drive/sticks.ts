// Everything that can be held to drive, as one pair of sticks. Hold to run: whatever is let go, lost or out
// of sight reads as neutral.
import { link } from '../link/live_link';
import { Store } from '../store';

export interface Deflection {
  pan: number;
  tilt: number;
}

const neutral: Deflection = { pan: 0, tilt: 0 };
const dead_zone = 0.15;
const slow = 0.3;
const period_ms = 50;

// Fine near the middle, full at the end.
function shaped(raw: number): number {
  const beyond = Math.max(0, Math.abs(raw) - dead_zone) / (1 - dead_zone);
  return Math.sign(raw) * Math.min(1, beyond * beyond);
}

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

class Sticks {
  /** What is held now. */
  readonly held = new Store<Deflection>(neutral);
  /** The name of a game controller that is connected, or nothing. */
  readonly controller = new Store<string>('');

  /** Somebody tried to drive who does not have the controls. */
  readonly denied = new Store(false);

  private readonly pressed = new Set<string>();
  private touch: Deflection = neutral;
  private stopWasPressed = false;
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

  /** Of the stick on the screen, -1 to 1 each; called again whenever it moves. */
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
    const isNeutral = now.pan === 0 && now.tilt === 0;
    const disarmed = link.status.value?.robot?.armed === false;
    if (isNeutral && this.sentNeutral && !disarmed) return;
    link.drive(now.pan, now.tilt);
    this.sentNeutral = isNeutral;
  }

  private read(): Deflection {
    const all = [this.fromController(), this.fromKeys(), this.touch];
    if (document.visibilityState !== 'visible' || !document.hasFocus()) return neutral;
    const sum = (axis: keyof Deflection) =>
      Math.max(-1, Math.min(1, all.reduce((total, deflection) => total + deflection[axis], 0)));
    return { pan: sum('pan'), tilt: sum('tilt') };
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

  // Standard mapping: the left stick drives, the right one slowly, the cross too; the right-hand button stops.
  private fromController(): Deflection {
    const pad = navigator.getGamepads().find((candidate) => candidate?.connected && candidate.mapping === 'standard');
    this.controller.value = pad?.id ?? '';
    if (!pad) return neutral;
    const stopButton = 1;
    const stopPressed = pad.buttons[stopButton]?.pressed ?? false;
    if (stopPressed && !this.stopWasPressed) link.stop();
    this.stopWasPressed = stopPressed;
    const axis = (i: number) => shaped(pad.axes[i] ?? 0);
    const button = (i: number) => (pad.buttons[i]?.pressed ? slow : 0);
    return {
      pan: -axis(0) - slow * axis(2) + button(14) - button(15),
      tilt: -axis(1) - slow * axis(3) + button(12) - button(13),
    };
  }
}

export const sticks = new Sticks();
