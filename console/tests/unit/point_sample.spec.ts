// The sample of the map's points that decides where the 3D view looks.
import { expect, test } from '@playwright/test';
import { middle, quantile, reach_m, shuffled } from '../../src/space/point_sample';

test('an order contains every number once, and is the same each time', () => {
  const order = shuffled(1000);
  expect([...order].sort((a, b) => a - b)).toEqual(Array.from({ length: 1000 }, (_, i) => i));
  expect(order.slice(0, 10)).not.toEqual(Uint32Array.from({ length: 10 }, (_, i) => i));
  expect(shuffled(1000)).toEqual(order);
  expect(shuffled(0)).toHaveLength(0);
});

test('the first points of an order are a fair sample', () => {
  const [count, few] = [100_000, 5000];
  const tenths = Array.from({ length: 10 }, () => 0);
  for (const number of shuffled(count).slice(0, few)) ++tenths[Math.floor((10 * number) / count)]!;
  for (const tenth of tenths) expect(Math.abs(tenth - few / 10), 'four standard deviations').toBeLessThan(4 * Math.sqrt(few * 0.09));
});

test('quantiles are taken by value, in any order', () => {
  const values = () => Float32Array.from([5, 1, 4, 2, 3]);
  expect([0, 0.5, 0.99, 1].map((share) => quantile(values(), share))).toEqual([1, 3, 4, 5]);
  expect(quantile(Float32Array.from([10, 9, -1]), 0), 'not in the order of their digits').toBe(-1);
  expect(quantile(new Float32Array(), 0.5)).toBe(0);
});

/** Points on a line along x, from 0 to 1 m, with one far away. */
function line(): Float32Array {
  const xyz = new Float32Array(3 * 101);
  for (let i = 0; i <= 99; ++i) xyz.set([i / 99, 2, -3], 3 * i);
  xyz.set([1000, 1000, 1000], 3 * 100);
  return xyz;
}

test('a point far away moves neither the middle nor the reach', () => {
  expect(middle(line(), 0)).toBeCloseTo(0.5, 1);
  expect(middle(line(), 1)).toBe(2);
  expect(reach_m(line(), [0.5, 2, -3])).toBeCloseTo(0.475, 1);
});

test('a single point has some reach, so that the camera does not stand in it', () => {
  expect(reach_m(Float32Array.from([1, 2, 3]), [1, 2, 3])).toBe(0.05);
  expect(reach_m(new Float32Array(), [0, 0, 0])).toBe(0.05);
});
