// Digits follow from the uncertainty.
import { expect, test } from '@playwright/test';
import { quantityText } from '../../src/measure/quantity';
import { gapShare, labelText, resultText } from '../../src/measure/result';
import type { Measurement } from '../../src/types';

test('the digits of a length follow from its uncertainty', () => {
  expect(quantityText(123.42, 0.81)).toBe('123.4 mm ± 0.8 mm');
  expect(quantityText(123.42, 1.24)).toBe('123.4 mm ± 1.2 mm');
  expect(quantityText(123.42, 0.14)).toBe('123.42 mm ± 0.14 mm');
  expect(quantityText(123.42, 0.96), 'rounded up to one more digit').toBe('123.4 mm ± 1.0 mm');
  expect(quantityText(123.42, 7.6)).toBe('123 mm ± 8 mm');
  expect(quantityText(1523.4, 14.9)).toBe('1523 mm ± 15 mm');
  expect(quantityText(5, 0.00001), 'no more than micrometres').toBe('5.000 mm ± 0.000 mm');
});

test('heights below are negative with a minus, and nothing is minus nothing', () => {
  expect(quantityText(-3.14, 0.2)).toBe('−3.1 mm ± 0.2 mm');
  expect(quantityText(-0.04, 0.2)).toBe('0.0 mm ± 0.2 mm');
  expect(quantityText(4, 0), 'an older server states none').toBe('4.0 mm');
});

const point = { position_m: [0, 0, 0.5], distance_m: 0.5, distance_uncertainty_mm: 3, near_edge: false } as Measurement['points'][number];

test('results in words', () => {
  expect(labelText({ tool: 'distance', points: [point] })).toBe('500 mm ± 3 mm');
  expect(labelText({ tool: 'height', points: [point], height_mm: -2, height_uncertainty_mm: 0.5 })).toBe('2.0 mm ± 0.5 mm below the surface');
  expect(labelText({ points: [null], problem: 'no depth is measured at point 1' })).toBe('no depth is measured at point 1');
  expect(labelText({ points: [null], problem: 'no depth', unmeasured: { reason: 'no-depth', part: 'point', point: 2 } })).toBe('No depth is measured at point 2');
  expect(resultText({ points: [point], problem: 'p', unmeasured: { reason: 'edge', part: 'surface' } })).toBe('The surface is at an edge between surfaces');
  expect(resultText({ tool: 'distance', points: [{ ...point!, near_edge: true }] })).toContain('near an edge');
});

test('a profile states its highest and lowest point, and what is missing', () => {
  const profile = [{ share: 0, along_mm: 0, height_mm: 0, height_uncertainty_mm: 0.4 }, { share: 0.5 }, { share: 1, along_mm: 10, height_mm: 6, height_uncertainty_mm: 0.4 }, { share: 1, along_mm: 10, height_mm: -1, height_uncertainty_mm: 0.4 }];
  expect(gapShare(profile)).toBe(0.25);
  expect(resultText({ tool: 'profile', points: [point, point], profile })).toBe('highest 6.0 mm ± 0.4 mm, lowest −1.0 mm ± 0.4 mm; 25 % not measured');
  const mistaken = { share: 0.6, along_mm: 6, height_mm: -3372, height_uncertainty_mm: 295 };
  expect(resultText({ tool: 'profile', points: [point, point], profile: [...profile, mistaken] })).toBe('highest 6.0 mm ± 0.4 mm, lowest −1.0 mm ± 0.4 mm; 40 % not measured');
  expect(resultText({ tool: 'profile', points: [point, point], profile: [{ share: 0 }] })).toBe('nothing is measured along this line');
});
