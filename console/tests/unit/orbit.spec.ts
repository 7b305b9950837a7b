// How the 3D view turns and which keys turn it.
import { expect, test } from '@playwright/test';
import { actionOf } from '../../src/space/keys';
import { brought, turned, type Xyz } from '../../src/space/orbit';

const length = (at: Xyz) => Math.hypot(...at);
const front: Xyz = [0, -2, 0];

function expectNear(at: Xyz, wanted: Xyz): void {
  at.forEach((value, i) => expect(value).toBeCloseTo(wanted[i]!));
}

test('the camera goes left and up around what it looks at', () => {
  expectNear(turned(front, Math.PI / 2, 0), [-2, 0, 0]);
  expectNear(turned(front, -Math.PI / 2, 0), [2, 0, 0]);
  expectNear(turned(front, 0, Math.PI / 4), [0, -Math.SQRT2, Math.SQRT2]);
});

test('turns keep the distance, and those there and back the place', () => {
  const start: Xyz = [0.3, -1.1, 0.4];
  for (const [left, up] of [[0.3, 0.2], [-2, 0.5], [7, -0.4]] as const) {
    expect(length(turned(start, left, up))).toBeCloseTo(length(start));
    expectNear(turned(turned(start, left, up), -left, -up), start);
  }
});

test('the view does not turn over at the top or below', () => {
  for (const up of [9, -9]) {
    const at = turned(front, 0, up);
    expect(Math.sign(at[2])).toBe(Math.sign(up));
    expect(Math.hypot(at[0], at[1]), 'not straight above, where left and right are not known').toBeGreaterThan(0.05);
    expect(at[1]).toBeLessThan(0);
  }
});

test('the camera comes nearer within limits, in the same direction', () => {
  expectNear(brought(front, 0.5, [0.1, 10]), [0, -1, 0]);
  expectNear(brought(front, 1e-3, [0.1, 10]), [0, -0.1, 0]);
  expectNear(brought(front, 1e3, [0.1, 10]), [0, -10, 0]);
});

test('arrow keys turn, with Shift they move, + and - zoom, 0 resets, and all others are left alone', () => {
  const none = { shiftKey: false, ctrlKey: false, altKey: false, metaKey: false };
  expect(actionOf({ ...none, key: 'ArrowLeft' })).toEqual({ kind: 'turn', right: -1, up: 0 });
  expect(actionOf({ ...none, key: 'ArrowUp', shiftKey: true })).toEqual({ kind: 'move', right: 0, up: 1 });
  const times = (key: string) => (actionOf({ ...none, key }) as { times: number }).times;
  expect(times('+')).toBeLessThan(1);
  expect(times('+') * times('-')).toBeCloseTo(1);
  expect(actionOf({ ...none, key: '0' })).toEqual({ kind: 'reset' });
  for (const key of ['a', 'Enter', 'Tab', 'Escape', '1']) expect(actionOf({ ...none, key }), key).toBeNull();
  expect(actionOf({ ...none, key: 'ArrowLeft', altKey: true }), 'back in the history').toBeNull();
});
