// The teaching of a controller's mapping: one push or press after another, each let go before the next.
import type { Pad } from './gamepads';
import type { Direction, TaughtMapping } from './pad_mapping';
import { rest_limit } from './stick_rest';

export type TeachingStep = 'rest' | 'right' | 'up' | 'stop' | 'let-go' | 'done';

const quiet_spread = 0.05;
const quiet_ms = 500;
const held_ms = 250;
const pushed = 0.6;
const let_go = 0.25;

export class Teaching {
  step: TeachingStep = 'rest';
  /** Complete once the step is 'done'. */
  mapping: TaughtMapping | null = null;

  private rest: Pad | null = null;
  private quiet: { pad: Pad; since_ms: number } | null = null;
  private candidate: (Direction & { since_ms: number }) | null = null;
  private right: Direction | null = null;
  private up: Direction | null = null;

  observe(pad: Pad, now_ms: number): void {
    if (this.step === 'done') return;
    if (!this.rest) this.learnRest(pad, now_ms);
    else if (this.step === 'right' && wasHeld(pad, this.rest)) this.startOver();
    else if (this.step === 'stop') this.learnStop(pad, this.rest);
    else if (this.step === 'let-go') this.awaitLettingGo(pad, this.rest);
    else this.learnDirection(pad, this.rest, now_ms);
  }

  private startOver(): void {
    this.step = 'rest';
    this.rest = null;
    this.quiet = null;
    this.candidate = null;
  }

  private learnRest(pad: Pad, now_ms: number): void {
    if (!this.quiet || !isQuiet(pad, this.quiet.pad)) this.quiet = { pad, since_ms: now_ms };
    if (now_ms - this.quiet.since_ms < quiet_ms) return;
    this.rest = pad;
    this.step = 'right';
  }

  private learnDirection(pad: Pad, rest: Pad, now_ms: number): void {
    const most = this.pushOf(pad, rest);
    if (!most || Math.abs(most.way) < pushed) {
      this.candidate = null;
      return;
    }
    const sign = most.way > 0 ? 1 : -1;
    if (this.candidate?.axis !== most.axis || this.candidate.sign !== sign)
      this.candidate = { axis: most.axis, sign, since_ms: now_ms };
    if (now_ms - this.candidate.since_ms < held_ms) return;
    if (this.step === 'right') this.right = { axis: most.axis, sign };
    else this.up = { axis: most.axis, sign };
    this.candidate = null;
    this.step = 'let-go';
  }

  private awaitLettingGo(pad: Pad, rest: Pad): void {
    const away = sticksOf(rest).some((i) => Math.abs((pad.axes[i] ?? 0) - (rest.axes[i] ?? 0)) > let_go);
    if (away || newlyPressed(pad, rest) >= 0) return;
    if (this.mapping) this.step = 'done';
    else this.step = this.up ? 'stop' : 'up';
  }

  private learnStop(pad: Pad, rest: Pad): void {
    const stop = newlyPressed(pad, rest);
    if (stop < 0 || !this.right || !this.up) return;
    this.mapping = { right: this.right, up: this.up, stop };
    this.step = 'let-go';
  }

  /** The axis that is pushed farthest, among those that have not been taught. */
  private pushOf(pad: Pad, rest: Pad): { axis: number; way: number } | undefined {
    return sticksOf(rest)
      .filter((axis) => axis !== this.right?.axis)
      .map((axis) => ({ axis, way: (pad.axes[axis] ?? 0) - (rest.axes[axis] ?? 0) }))
      .sort((one, other) => Math.abs(other.way) - Math.abs(one.way))[0];
  }
}

function isQuiet(pad: Pad, before: Pad): boolean {
  const samePlaces = pad.axes.every((raw, i) => !(Math.abs(raw - (before.axes[i] ?? 0)) > quiet_spread));
  return samePlaces && newlyPressed(pad, before) < 0 && newlyPressed(before, pad) < 0;
}

// The axes that are sticks. Triggers rest at an end, and a cross that is reported as an axis rests beyond it.
function sticksOf(rest: Pad): number[] {
  return rest.axes.flatMap((raw, i) => (Math.abs(raw) < rest_limit ? [i] : []));
}

// An axis that was far out at rest and comes back is a stick that was held while its rest was learnt.
function wasHeld(pad: Pad, rest: Pad): boolean {
  return rest.axes.some((raw, i) => Math.abs(raw) >= rest_limit && Math.abs(pad.axes[i] ?? NaN) < let_go);
}

/** The first button that is pressed and was not pressed at rest, or -1. */
function newlyPressed(pad: Pad, rest: Pad): number {
  return pad.buttons.findIndex((isPressed, i) => isPressed && !rest.buttons[i]);
}
