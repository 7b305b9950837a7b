// Regions as polygons: how much they cover, what lies in them, and how they are changed. Without a browser.
import { expect, test } from '@playwright/test';
import { boundsOf, contains, coveredShare, isNear, middleRectangle, moved, rectangle, regionAt, resized } from '../../src/regions/shapes';
import { percent } from '../../src/regions/region_words';
import type { Polygon } from '../../src/types';

const size = { width: 80, height: 40 };
const square: Polygon = [[9.5, 9.5], [19.5, 9.5], [19.5, 19.5], [9.5, 19.5]];
const arrowhead: Polygon = [[0, 0], [30, 15], [0, 30], [10, 15]];

test.describe('the covered share', () => {
  test('counts the pixels whose centres lie inside', () => {
    expect(coveredShare([], size)).toBe(0);
    expect(coveredShare([square], size)).toBe(100 / 3200);
    expect(coveredShare([[[-0.5, -0.5], [79.5, -0.5], [79.5, 39.5], [-0.5, 39.5]]], size)).toBe(1);
  });

  test('counts what lies in two regions once', () => {
    expect(coveredShare([square, moved(square, size, 5, 0)], size)).toBe(150 / 3200);
    expect(coveredShare([square, square], size)).toBe(100 / 3200);
  });

  test('counts nothing beyond the picture', () => {
    expect(coveredShare([[[-100, -100], [9.5, -100], [9.5, 9.5], [-100, 9.5]]], size)).toBe(100 / 3200);
  });

  test('is about the area of a polygon that is not convex', () => {
    expect(coveredShare([arrowhead], size) * 3200).toBeCloseTo(300, -2);
  });

  test('is never shown as nothing where there is something', () => {
    expect([0, 0.001, 0.124, 1].map(percent)).toEqual(['0 %', 'less than 1 %', '12 %', '100 %']);
  });
});

test.describe('a position', () => {
  test('lies in a region or not', () => {
    expect(contains(square, [15, 15])).toBe(true);
    for (const outside of [[5, 15], [25, 15], [15, 5], [15, 25]] as const) expect(contains(square, [...outside])).toBe(false);
    expect(contains(arrowhead, [20, 15])).toBe(true);
    expect(contains(arrowhead, [5, 15]), 'between the barbs').toBe(false);
  });

  test('selects the region that is drawn last', () => {
    const regions = [square, moved(square, size, 5, 0)];
    expect(regionAt(regions, [12, 15])).toBe(0);
    expect(regionAt(regions, [17, 15])).toBe(1);
    expect(regionAt(regions, [70, 35])).toBe(-1);
  });

  test('is near another one within a circle', () => {
    expect(isNear([10, 10], [13, 14], 5)).toBe(true);
    expect(isNear([10, 10], [14, 14], 5)).toBe(false);
  });
});

test.describe('a rectangle', () => {
  test('lies between two corners in any order, within the picture', () => {
    const drawn = { left: 10, top: 20, right: 79.5, bottom: 39.5 };
    expect(boundsOf(rectangle(size, [10, 20], [200, 200])!)).toEqual(drawn);
    expect(boundsOf(rectangle(size, [200, 20], [10, 200])!)).toEqual(drawn);
  });

  test('that is next to nothing was not meant', () => {
    expect(rectangle(size, [10, 10], [50, 12])).toBeNull();
    expect(rectangle(size, [10, 10], [11, 30])).toBeNull();
  });

  test('stands in the middle at first', () => {
    expect(boundsOf(middleRectangle(size))).toEqual({ left: 29.5, top: 14.5, right: 49.5, bottom: 24.5 });
  });
});

test.describe('a region', () => {
  test('is moved up to the edge, and keeps its shape', () => {
    expect(boundsOf(moved(square, size, 8, -3))).toEqual({ left: 17.5, top: 6.5, right: 27.5, bottom: 16.5 });
    expect(boundsOf(moved(square, size, 500, 500))).toEqual({ left: 69.5, top: 29.5, right: 79.5, bottom: 39.5 });
    expect(boundsOf(moved(square, size, -500, 0))).toEqual({ left: -0.5, top: 9.5, right: 9.5, bottom: 19.5 });
  });

  test('is made larger and smaller at its right and lower side', () => {
    expect(boundsOf(resized(square, size, 8, 0))).toEqual({ left: 9.5, top: 9.5, right: 27.5, bottom: 19.5 });
    expect(boundsOf(resized(square, size, -500, -500)), 'still to be seen').toEqual({ left: 9.5, top: 9.5, right: 13.5, bottom: 13.5 });
    expect(boundsOf(resized(square, size, 500, 500))).toEqual({ left: 9.5, top: 9.5, right: 79.5, bottom: 39.5 });
    expect(resized([[5, 5], [5, 9], [5, 20]], size, 8, 0), 'without a width').toEqual([[5, 5], [5, 9], [5, 20]]);
  });
});
