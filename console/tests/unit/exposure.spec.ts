// Sliders of quantities that span orders of magnitude.
import { expect, test } from '@playwright/test';
import { positionOf, valueAt } from '../../src/live/exposure';
import type { Range } from '../../src/types';

const range: Range = [1, 33000];

test('positions and values are inverse to each other, and both ends are exact', () => {
  expect(valueAt(0, range)).toBe(1);
  expect(valueAt(1, range)).toBe(33000);
  for (const position of [0, 0.1, 0.5, 0.93, 1]) expect(positionOf(valueAt(position, range), range)).toBeCloseTo(position, 9);
});

test('equal steps are equal ratios', () => {
  expect(valueAt(0.5, [16, 256])).toBeCloseTo(64, 9);
});

test('a value beyond the range is at its end', () => {
  expect(positionOf(165000, range)).toBe(1);
  expect(positionOf(0.1, range)).toBe(0);
});
