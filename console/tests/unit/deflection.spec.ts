// Deflections of all inputs together.
import { expect, test } from '@playwright/test';
import { isNeutral, neutral, sumOf } from '../../src/drive/deflection';

test('deflections add up, to full deflection at most', () => {
  expect(sumOf([])).toEqual(neutral);
  expect(sumOf([{ pan: 0.5, tilt: -0.25 }, { pan: 0.25, tilt: -0.25 }])).toEqual({ pan: 0.75, tilt: -0.5 });
  expect(sumOf([{ pan: 1, tilt: -1 }, { pan: 0.3, tilt: -1 }])).toEqual({ pan: 1, tilt: -1 });
});

test('opposite keys cancel', () => {
  expect(isNeutral(sumOf([{ pan: 1, tilt: 0 }, { pan: -1, tilt: 0 }]))).toBe(true);
});

test('one deflected axis is not neutral', () => {
  expect(isNeutral(neutral)).toBe(true);
  expect(isNeutral({ pan: 0, tilt: 0.01 })).toBe(false);
  expect(isNeutral({ pan: -0.01, tilt: 0 })).toBe(false);
});
