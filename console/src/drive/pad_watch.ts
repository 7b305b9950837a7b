// One controller over time: how far its sticks are deflected, and whether they come to rest.
import { type Deflection, isNeutral, neutral, sumOf } from './deflection';
import type { Pad } from './gamepads';
import type { Layout } from './pad_mapping';
import { StickRest } from './stick_rest';

// A stick must rest this long to count as let go: one that only passes through the middle, or whose contacts are
// loose, has not been let go.
const settled_ms = 300;
const patience_ms = 3000;
// A smaller change may be noise.
const movement = 0.1;

export class PadWatch {
  /** Its sticks do not come to rest; it does not turn the camera until they do. */
  restless = false;
  deflection: Deflection = neutral;
  /** When its deflection last began or changed. */
  moved_ms = -Infinity;

  private readonly rests: StickRest[];
  private calmSince_ms: number | null = null;
  private unsettledSince_ms: number | null = null;
  private hasRested = false;
  private held: Deflection = neutral;
  private movedTo: Deflection = neutral;

  constructor(private readonly layout: Layout) {
    this.rests = layout.axes.map(() => new StickRest());
  }

  /** @param disarmed whether the robot waits for all sticks to be let go */
  observe(pad: Pad, now_ms: number, dead_zone: number, disarmed: boolean): void {
    this.rests.forEach((rest, i) => rest.observe(this.raw(pad, i), now_ms, dead_zone));
    const deflection = this.read(pad, dead_zone);
    const astray = this.rests.some((rest, i) => rest.isAstray(this.raw(pad, i), dead_zone));
    if (astray || !isNeutral(deflection)) {
      this.calmSince_ms = null;
      this.held = deflection;
    } else {
      this.calmSince_ms ??= now_ms;
    }
    const settled = this.calmSince_ms !== null && now_ms - this.calmSince_ms >= settled_ms;
    this.judge(settled, now_ms, disarmed);
    // While the robot waits for it, a stick counts as held until it has settled.
    const awaited = disarmed && !settled && isNeutral(deflection) ? this.held : deflection;
    this.deflection = this.restless ? neutral : awaited;
    this.noteMovement(now_ms);
  }

  // A stick that is held from before the controller was connected, or from before a stop, is either about to be
  // let go or broken. A broken one must not keep the other ways of driving from arming the robot.
  private judge(settled: boolean, now_ms: number, disarmed: boolean): void {
    if (settled) {
      this.restless = false;
      this.hasRested = true;
      this.held = neutral;
    }
    if (settled || (this.hasRested && !disarmed)) {
      this.unsettledSince_ms = null;
      return;
    }
    this.unsettledSince_ms ??= now_ms;
    if (now_ms - this.unsettledSince_ms >= patience_ms) this.restless = true;
  }

  private noteMovement(now_ms: number): void {
    const { pan, tilt } = this.deflection;
    const began = isNeutral(this.movedTo) && !isNeutral(this.deflection);
    const wentOn = Math.max(Math.abs(pan - this.movedTo.pan), Math.abs(tilt - this.movedTo.tilt)) > movement;
    if (isNeutral(this.deflection)) this.movedTo = neutral;
    else if (began || wentOn) {
      this.movedTo = this.deflection;
      this.moved_ms = now_ms;
    }
  }

  private raw(pad: Pad, i: number): number {
    return pad.axes[this.layout.axes[i]?.at ?? 0] ?? 0;
  }

  private read(pad: Pad, dead_zone: number): Deflection {
    const sticks = this.layout.axes.map(({ turns, scale }, i) => ({
      ...neutral,
      [turns]: scale * (this.rests[i]?.deflection(this.raw(pad, i), dead_zone) ?? 0),
    }));
    const pressed = this.layout.buttons
      .filter(({ at }) => pad.buttons[at])
      .map(({ turns, scale }) => ({ ...neutral, [turns]: scale }));
    return sumOf([...sticks, ...pressed]);
  }
}
