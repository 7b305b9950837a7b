// Controllers as they are: worn, stuck, several, without the standard mapping. Without a browser.
import { expect, test } from '@playwright/test';
import { Controllers, type PadSettings } from '../../src/drive/controllers';
import { nameOf, type Pad } from '../../src/drive/gamepads';
import { isTaughtMapping, type TaughtMapping } from '../../src/drive/pad_mapping';
import { StickRest } from '../../src/drive/stick_rest';
import { Teaching } from '../../src/drive/teaching';

const dead_zone = 0.15;
const period_ms = 50;
const buttons = Array.from({ length: 17 }, () => false);

function padAt(axes: number[], more: Partial<Pad> = {}): Pad {
  return { slot: 0, id: 'Xbox', standard: true, axes, buttons, ...more };
}

function pressed(button: number): boolean[] {
  return buttons.map((_, i) => i === button);
}

/** The controllers over time. */
class Bench {
  private readonly controllers = new Controllers();
  private now_ms = 1000;
  settings: PadSettings = { dead_zone, taught: {}, teaching: null };
  disarmed = false;

  read(...pads: Pad[]) {
    this.now_ms += period_ms;
    return this.controllers.read(pads, this.now_ms, this.settings, this.disarmed);
  }

  readFor(seconds: number, ...pads: Pad[]) {
    const readings = Array.from({ length: (1000 * seconds) / period_ms }, () => this.read(...pads));
    return readings.at(-1)!;
  }
}

const neutral = { pan: 0, tilt: 0 };

test.describe('a stick', () => {
  function restingAt(raw: number, zone = dead_zone): StickRest {
    const rest = new StickRest();
    for (let now_ms = 0; now_ms <= 1000; now_ms += period_ms) rest.observe(raw, now_ms, zone);
    return rest;
  }

  for (const at of [0, 0.2, -0.3])
    for (const zone of [0.05, dead_zone, 0.5])
      test(`that rests at ${at} with a dead zone of ${zone}: 0 there, 1 at the end, steady between`, () => {
        const rest = restingAt(at, zone);
        expect(rest.deflection(at, zone)).toBe(0);
        expect(rest.deflection(1, zone)).toBe(1);
        expect(rest.deflection(-1, zone)).toBe(-1);
        for (let raw = -1; raw < 1; raw += 0.01) {
          const step = rest.deflection(raw + 0.01, zone) - rest.deflection(raw, zone);
          expect(step).toBeGreaterThanOrEqual(0);
          expect(step).toBeLessThan(0.25);
        }
      });

  test('that is let go after its rest was learnt while it was held turns nothing', () => {
    const rest = restingAt(0.3);
    expect(rest.deflection(0.3, dead_zone)).toBe(0);
    expect(rest.deflection(0, dead_zone)).toBe(0);
  });

  test('that was held far out has no rest there', () => {
    const rest = restingAt(0.6);
    expect(rest.isAstray(0.6, dead_zone)).toBe(true);
    expect(restingAt(0.2).isAstray(0.2, dead_zone)).toBe(false);
  });

  test('whose rest is not known counts only when it is clearly deflected', () => {
    const rest = new StickRest();
    expect(rest.deflection(0.6, dead_zone)).toBe(0);
    expect(rest.deflection(-1, dead_zone)).toBe(-1);
  });

  test('that wears on is learnt anew', () => {
    const rest = restingAt(0);
    expect(rest.deflection(0.25, dead_zone)).toBeGreaterThan(0);
    for (let now_ms = 2000; now_ms <= 5000; now_ms += period_ms) rest.observe(0.25, now_ms, dead_zone);
    expect(rest.deflection(0.25, dead_zone)).toBe(0);
  });
});

test.describe('one controller', () => {
  test('that is worn never creeps', () => {
    const bench = new Bench();
    for (let i = 0; i < 100; ++i) {
      const shake = 0.02 * (i % 2);
      expect(bench.read(padAt([0.16 + shake, 0.2 - shake, 0, 0])).deflection).toEqual(neutral);
    }
    expect(bench.read(padAt([-1, 0.2, 0, 0])).deflection).toEqual({ pan: 1, tilt: 0 });
    expect(bench.read(padAt([0.16, 0.5, 0, 0])).deflection.tilt, 'pushed a little').toBeLessThan(0);
  });

  test('without four axes or with strange ones disturbs nothing', () => {
    const bench = new Bench();
    expect(bench.readFor(1, padAt([])).deflection).toEqual(neutral);
    expect(bench.readFor(1, padAt([NaN, Infinity, 0, 0])).deflection).toEqual(neutral);
    const strange = padAt([NaN, Infinity, 0, 0], { slot: 1 });
    expect(bench.readFor(4, padAt([0, 0, 0, 0]), strange).reports.map(({ state }) => state)).toEqual(['ready', 'restless']);
    expect(bench.read(padAt([0, -1, 0, 0]), strange).deflection).toEqual({ pan: 0, tilt: 1 });
  });

  test('turns slowly with the right stick and the cross', () => {
    const bench = new Bench();
    bench.readFor(1, padAt([0, 0, 0, 0]));
    expect(bench.read(padAt([0, 0, 1, 0])).deflection).toEqual({ pan: -0.3, tilt: 0 });
    expect(bench.read(padAt([0, 0, 0, 0], { buttons: pressed(12) })).deflection).toEqual({ pan: 0, tilt: 0.3 });
  });

  test('whose stick is stuck is ignored after a while, until it has rested', () => {
    for (const stuck of [0.6, 1]) {
      const bench = new Bench();
      const reading = bench.readFor(4, padAt([stuck, 0, 0, 0]));
      expect(reading.deflection).toEqual(neutral);
      expect(reading.reports[0]!.state).toBe('restless');
      expect(bench.readFor(1, padAt([0, 0, 0, 0])).reports[0]!.state).toBe('ready');
      expect(bench.read(padAt([-1, 0, 0, 0])).deflection).toEqual({ pan: 1, tilt: 0 });
    }
  });

  test('turns as long as it is held, and after a stop waits to be let go, but not for ever', () => {
    const bench = new Bench();
    bench.readFor(1, padAt([0, 0, 0, 0]));
    expect(bench.readFor(30, padAt([-1, 0, 0, 0])).deflection).toEqual({ pan: 1, tilt: 0 });
    bench.disarmed = true;
    expect(bench.readFor(1, padAt([-1, 0, 0, 0])).deflection, 'held').toEqual({ pan: 1, tilt: 0 });
    expect(bench.readFor(3, padAt([-1, 0, 0, 0])).deflection, 'ignored').toEqual(neutral);
  });

  test('with a loose contact is not taken for one that was let go', () => {
    const bench = new Bench();
    bench.readFor(1, padAt([0, 0, 0, 0]));
    bench.readFor(1, padAt([-1, 0, 0, 0]));
    bench.disarmed = true;
    expect(bench.read(padAt([0, 0, 0, 0])).deflection).toEqual({ pan: 1, tilt: 0 });
    bench.readFor(1, padAt([-1, 0, 0, 0]));
    expect(bench.readFor(0.5, padAt([0, 0, 0, 0])).deflection).toEqual(neutral);
  });

  test('that stops while the page is opened stops once', () => {
    const bench = new Bench();
    expect(bench.read(padAt([0, 0, 0, 0], { buttons: pressed(1) })).stop).toBe(true);
    expect(bench.read(padAt([0, 0, 0, 0], { buttons: pressed(1) })).stop).toBe(false);
  });
});

test.describe('two controllers', () => {
  const other = { slot: 1, id: 'Other' };

  test('the one that moves is read, the first or the second', () => {
    const bench = new Bench();
    const reading = bench.read(padAt([0, 0, 0, 0]), padAt([0, -1, 0, 0], other));
    expect(reading.deflection).toEqual({ pan: 0, tilt: 1 });
    expect(reading.id).toBe('Other');
  });

  test('the latest movement wins, they never add up, and the other one takes over', () => {
    const bench = new Bench();
    bench.readFor(1, padAt([0, 0, 0, 0]), padAt([0, 0, 0, 0], other));
    expect(bench.read(padAt([-1, 0, 0, 0]), padAt([0, 0, 0, 0], other)).deflection).toEqual({ pan: 1, tilt: 0 });
    expect(bench.read(padAt([-1, 0, 0, 0]), padAt([0, 1, 0, 0], other)).deflection).toEqual({ pan: 0, tilt: -1 });
    expect(bench.read(padAt([1, 0, 0, 0]), padAt([0, 1, 0, 0], other)).deflection).toEqual({ pan: -1, tilt: 0 });
    expect(bench.read(padAt([0, 0, 0, 0]), padAt([0, 1, 0, 0], other)).deflection).toEqual({ pan: 0, tilt: -1 });
    expect(bench.read(padAt([0, 0, 0, 0])).deflection, 'unplugged').toEqual(neutral);
  });

  test('each of them stops the robot', () => {
    const bench = new Bench();
    bench.readFor(1, padAt([0, 0, 0, 0]), padAt([0, 0, 0, 0], other));
    expect(bench.read(padAt([-1, 0, 0, 0]), padAt([0, 0, 0, 0], { ...other, buttons: pressed(1) })).stop).toBe(true);
  });
});

test.describe('a controller without the standard mapping', () => {
  const odd = { id: '054c-0268-Odd', standard: false };
  const atRest = [0, 0, -1, 0, 0, -1];

  /** Shows the axes for long enough to be understood. */
  function show(teaching: Teaching, clock: { ms: number }, axes: number[], more: Partial<Pad> = {}): void {
    for (let i = 0; i < 20; ++i) teaching.observe(padAt(axes, { ...odd, ...more }), (clock.ms += period_ms));
  }

  function taught(): TaughtMapping | null {
    const teaching = new Teaching();
    const clock = { ms: 0 };
    expect(teaching.step).toBe('rest');
    show(teaching, clock, [0, 0, -1, 0, 0.9, -1]);
    show(teaching, clock, atRest);
    expect(teaching.step, 'a stick that was held is let go').toBe('right');
    show(teaching, clock, [0, 0, 1, 0, 0, -1]);
    expect(teaching.step, 'a trigger is no stick').toBe('right');
    show(teaching, clock, atRest);
    show(teaching, clock, [0.2, 0, -1, 0.95, 0, -1]);
    expect(teaching.step).toBe('let-go');
    show(teaching, clock, atRest);
    expect(teaching.step).toBe('up');
    show(teaching, clock, [0, 0, -1, 0.9, -0.8, -1]);
    expect(teaching.step).toBe('let-go');
    show(teaching, clock, atRest);
    expect(teaching.step).toBe('stop');
    show(teaching, clock, atRest, { buttons: pressed(7) });
    expect(teaching.step).toBe('let-go');
    show(teaching, clock, atRest);
    expect(teaching.step).toBe('done');
    return teaching.mapping;
  }

  test('is reported, and turns nothing', () => {
    const reading = new Bench().readFor(1, padAt([0, -1, 0, 0, 0, 0], odd));
    expect(reading).toMatchObject({ deflection: neutral, id: odd.id, reports: [{ state: 'unmapped' }] });
  });

  test('is taught by pushing and pressing, and then turns and stops', () => {
    const mapping = taught()!;
    expect(mapping).toEqual({ right: { axis: 3, sign: 1 }, up: { axis: 4, sign: -1 }, stop: 7 });
    const bench = new Bench();
    bench.settings = { ...bench.settings, taught: { [odd.id]: mapping } };
    bench.readFor(1, padAt(atRest, odd));
    expect(bench.read(padAt([0, 0, -1, 1, 0, -1], odd)).deflection).toEqual({ pan: -1, tilt: 0 });
    expect(bench.read(padAt([0, 0, -1, 0, -1, -1], odd)).deflection).toEqual({ pan: 0, tilt: 1 });
    expect(bench.read(padAt(atRest, { ...odd, buttons: pressed(7) })).stop).toBe(true);
    bench.settings = { ...bench.settings, teaching: 0 };
    expect(bench.read(padAt([0, 0, -1, 1, 0, -1], odd)).deflection, 'while it is taught anew').toEqual(neutral);
  });

  test('what was stored and is no mapping is not used', () => {
    const mapping = taught();
    expect(isTaughtMapping(mapping)).toBe(true);
    for (const wrong of [null, 3, {}, { ...mapping, stop: -1 }, { ...mapping, up: mapping!.right }, { ...mapping, right: { axis: 0, sign: 2 } }])
      expect(isTaughtMapping(wrong)).toBe(false);
  });

  test('is named without its identifiers', () => {
    expect(nameOf('Xbox 360 Controller (STANDARD GAMEPAD Vendor: 045e Product: 028e)')).toBe('Xbox 360 Controller');
    expect(nameOf('045e-028e-Microsoft X-Box 360 pad')).toBe('Microsoft X-Box 360 pad');
    expect(nameOf('')).toBe('Controller');
  });
});
