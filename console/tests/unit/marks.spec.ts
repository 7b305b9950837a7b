// Boxes that a person marks: whole pixels, within the picture, whatever was tapped or drawn. Without a browser.
import { expect, test } from '@playwright/test';
import { boxAround, boxBetween, boxInMiddle, least_px, movedBox, resizedBox, tap_px } from '../../src/picture/marks';
import type { Box, Pixel } from '../../src/types';

const size = { width: 80, height: 40 };
const places: Pixel[] = [-50, -0.5, 0, 7.3, 39.5, 60, 79.5, 200].flatMap((u) => [-9, -0.5, 12.4, 39.5, 90].map((v) => ({ u, v })));

function isWithin(box: Box): boolean {
  const [u, v, width, height] = box;
  return box.every(Number.isInteger) && Math.min(u, v) >= 0 && Math.min(width, height) >= least_px && u + width <= size.width && v + height <= size.height;
}

test('whatever is tapped, drawn, moved or resized stays within the picture', () => {
  const start: Box = [20, 10, 30, 20];
  const boxes = places.flatMap((a) => [
    boxAround(a, size),
    ...places.map((b) => boxBetween(a, b, size)),
    ...[movedBox, resizedBox].map((change) => change(start, size, 3 * Math.round(a.u), 3 * Math.round(a.v))),
  ]);
  expect(boxes.filter((box) => !isWithin(box))).toEqual([]);
});

test('a tap marks a square around it', () => {
  expect(boxAround({ u: 40, v: 20 }, size)).toEqual([29, 9, tap_px, tap_px]);
  expect(boxAround({ u: 0, v: 39 }, size)).toEqual([0, 16, tap_px, tap_px]);
});

test('a box reaches from one corner to the other, both included, in any order', () => {
  const [a, b] = [{ u: 10.2, v: 30.4 }, { u: 24.9, v: 12.1 }];
  expect(boxBetween(a, b, size)).toEqual([10, 12, 16, 19]);
  expect(boxBetween(b, a, size)).toEqual([10, 12, 16, 19]);
});

test('a box is moved without being resized, and resized without being moved', () => {
  expect(movedBox([20, 10, 30, 20], size, 5, -3)).toEqual([25, 7, 30, 20]);
  expect(movedBox([20, 10, 30, 20], size, 500, 500)).toEqual([50, 20, 30, 20]);
  expect(resizedBox([20, 10, 30, 20], size, 5, -3)).toEqual([20, 10, 35, 17]);
  expect(resizedBox([20, 10, 30, 20], size, -500, 500)).toEqual([20, 10, least_px, 30]);
});

test('the middle is that of the part that is shown', () => {
  expect(boxInMiddle([0, 0, 80, 40], size)).toEqual([37, 17, 7, 7]);
  expect(boxInMiddle([60, 30, 20, 10], size)).toEqual([68, 33, 4, 4]);
});
