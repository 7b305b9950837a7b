// The part of a picture that a close-up shows. Without a browser.
import { expect, test } from '@playwright/test';
import { cropAround } from '../../src/picture/crop';
import type { Box } from '../../src/types';

const size = { width: 848, height: 480 };
const boxes: Box[] = [[0, 0, 3, 3], [845, 477, 3, 3], [400, 200, 40, 20], [400, 100, 10, 150], [100, 100, 500, 300], [0, 0, 848, 480]];

test('a part contains its box and lies within the picture', () => {
  const wrong = boxes.filter((box) => {
    const [u, v, width, height] = cropAround(box, size, 64);
    const inside = u >= 0 && v >= 0 && u + width <= size.width && v + height <= size.height;
    return !inside || u > box[0] || v > box[1] || u + width < box[0] + box[2] || v + height < box[1] + box[3];
  });
  expect(wrong).toEqual([]);
});

test('a part is at least twice its box, where the picture is large enough, and not too small to be enlarged', () => {
  for (const box of boxes) {
    const [, , width, height] = cropAround(box, size, 64);
    expect(width, String(box)).toBeGreaterThanOrEqual(Math.min(size.width, Math.max(64, 2 * box[2])));
    expect(height, String(box)).toBeGreaterThanOrEqual(Math.min(size.height, Math.max(48, 2 * box[3])));
  }
});

test('a part has its box in the middle, away from the edges', () => {
  expect(cropAround([400, 200, 60, 30], size, 64)).toEqual([370, 170, 120, 90]);
  expect(cropAround([400, 200, 4, 4], size, 64)).toEqual([370, 178, 64, 48]);
});
