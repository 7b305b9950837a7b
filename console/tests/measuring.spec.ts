// Measuring in the live picture, in those of the review and in the map, with uncertainties.
import type { Page } from '@playwright/test';
import { expectAccessible, expectTouchable } from './accessibility';
import type { Measurement, MeasureRequest, ViewMeasureRequest } from '../src/types';
import { openReview, wall } from './review_page';
import { expect, test } from './served';

const quantity = /\d(\.\d+)? mm ± \d+(\.\d+)? mm/;
const result = (page: Page) => page.getByTestId('measure-result');

async function tap(page: Page, x: number, y: number, testId = 'picture'): Promise<void> {
  const box = (await page.getByTestId(testId).boundingBox())!;
  await page.mouse.click(box.x + x * box.width, box.y + y * box.height);
  // A second tap soon and nearby would be a double tap.
  await page.waitForTimeout(400);
}

async function drag(page: Page, [x1, y1]: [number, number], [x2, y2]: [number, number]): Promise<void> {
  const box = (await page.getByTestId('picture').boundingBox())!;
  await page.mouse.move(box.x + x1 * box.width, box.y + y1 * box.height);
  await page.mouse.down();
  await page.mouse.move(box.x + ((x1 + x2) / 2) * box.width, box.y + ((y1 + y2) / 2) * box.height);
  await page.mouse.move(box.x + x2 * box.width, box.y + y2 * box.height);
  await page.mouse.up();
}

test('the tools of the live picture, by taps and by keyboard', async ({ console: page }) => {
  await expect.poll(async () => Number(await page.getByTestId('live').getAttribute('data-frame'))).toBeGreaterThan(0);
  await page.getByTestId('measure-begin').click();
  await expectTouchable(page);
  await tap(page, 0.4, 0.7);
  await expect(result(page)).toHaveText('Tap the other end.');
  await tap(page, 0.6, 0.7);
  await expect(result(page)).toHaveText(quantity);

  await page.getByTestId('tool-height').click();
  await expect(result(page)).toContainText('Drag a rectangle over the flat surface');
  await expectTouchable(page);
  const asked = page.waitForRequest('**/api/measure');
  await drag(page, [0.35, 0.62], [0.65, 0.8]);
  await expect(page.getByTestId('surface')).toBeVisible();
  await expect(result(page)).toHaveText('Now tap the top of the object.');
  await tap(page, 0.5, 0.7);
  await expect(result(page)).toContainText(/mm ± .* (above|below) the surface/);
  const request = (await asked).postDataJSON() as MeasureRequest;
  expect(request).toMatchObject({ tool: 'height', points: [{}] });
  const drawn = [0.35 * 848, 0.62 * 480, 0.3 * 848, 0.18 * 480];
  request.bbox!.forEach((value, i) => expect(Math.abs(value - drawn[i]!)).toBeLessThan(3));
  // Another point above the same surface, and then another surface, by a tap.
  await tap(page, 0.6, 0.65);
  await expect(result(page)).toContainText(/mm ± .* (above|below) the surface/);
  await expect(page.getByTestId('surface')).toBeVisible();
  await page.getByTestId('measure-clear').click();
  await expect(page.getByTestId('surface')).toHaveCount(0);
  await tap(page, 0.4, 0.7);
  expect(Number(await page.getByTestId('surface').getAttribute('width'))).toBe(64);
  await page.getByTestId('measure-clear').click();

  // By keyboard, what is in the middle.
  await page.getByTestId('picture').focus();
  await page.keyboard.press('+');
  await page.keyboard.press('ArrowDown');
  await page.getByTestId('measure-middle').press('Enter');
  await expect(page.getByTestId('mark-box')).toBeFocused();
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('Shift+ArrowRight');
  await expectAccessible(page);
  await page.keyboard.press('Enter');
  await expect(page.getByTestId('surface')).toBeVisible();
  await page.getByTestId('measure-middle').press('Enter');
  await expect(result(page)).toContainText(/mm ± .* (above|below) the surface/);
  await page.getByTestId('picture').focus();
  await page.keyboard.press('0');

  await page.getByTestId('tool-profile').click();
  await tap(page, 0.4, 0.7);
  await tap(page, 0.6, 0.7);
  await expect(page.getByTestId('profile')).toBeVisible();
  await expect(result(page)).toContainText(/highest .* mm ± .*lowest/);
  await expectTouchable(page);
  await expectAccessible(page);
  await page.getByTestId('measure-clear').click();
  await expect(page.getByTestId('profile')).toHaveCount(0);
  await page.keyboard.press('Escape');
  await expect(page.getByTestId('measure-begin')).toBeVisible();
});

// What the server measures is tested with the server; here its answer is known.
const point = { position_m: [0, 0.6, 0], distance_m: 0.6, distance_uncertainty_mm: 3, near_edge: false };
const answers: Record<string, Measurement> = {
  distance: { tool: 'distance', points: [point] as Measurement['points'] },
  length: { tool: 'length', points: [point, point] as Measurement['points'], length_mm: 123.42, length_uncertainty_mm: 0.83 },
  height: { tool: 'height', points: [point] as Measurement['points'], height_mm: 12.34, height_uncertainty_mm: 0.83 },
  profile: {
    tool: 'profile', points: [point, point] as Measurement['points'],
    profile: [{ share: 0, along_mm: 0, height_mm: 0, height_uncertainty_mm: 0.4 }, { share: 0.5 }, { share: 1, along_mm: 50, height_mm: 6, height_uncertainty_mm: 0.4 }],
  },
};

async function answerMeasurements(page: Page): Promise<void> {
  await page.route('**/measure', (route) => {
    const { tool = 'length' } = route.request().postDataJSON() as { tool?: string };
    return route.fulfill({ json: answers[tool] });
  });
}

test('before and after the work', async ({ console: page }) => {
  await openReview(page);
  await answerMeasurements(page);
  for (const [moment, side] of [['after', 'final'], ['before', 'initial']] as const) {
    await page.getByTestId(`moment-${moment}`).click();
    await page.getByTestId('measure-begin').click();
    const asked = page.waitForRequest('**/rounds/1/views/0/measure');
    await tap(page, 0.4, 0.7);
    await tap(page, 0.6, 0.7);
    await expect(result(page)).toHaveText('123.4 mm ± 0.8 mm');
    expect((await asked).postDataJSON()).toMatchObject({ side });
    await page.getByTestId('tool-profile').click();
    await tap(page, 0.4, 0.7);
    await tap(page, 0.6, 0.7);
    await expect(page.getByTestId('profile')).toBeVisible();
    await expect(result(page)).toContainText('33 % not measured');
    await page.getByTestId('tool-height').click();
    const height = page.waitForRequest('**/rounds/1/views/0/measure');
    await drag(page, [0.3, 0.3], [0.5, 0.6]);
    await tap(page, 0.4, 0.45);
    await expect(result(page)).toHaveText('12.3 mm ± 0.8 mm above the surface');
    const { bbox, points } = (await height).postDataJSON() as ViewMeasureRequest;
    expect(points).toHaveLength(1);
    expect(Math.abs(bbox![2] - 0.2 * 848)).toBeLessThan(3);
    await expectTouchable(page);
    await expectAccessible(page);
    await page.getByTestId('measure-leave').click();
    await expect(page.getByTestId('surface')).toHaveCount(0);
  }
});

test('in the map, between two of its points', async ({ console: page }) => {
  await openReview(page);
  await answerMeasurements(page);
  for (const name of ['map', 'changes']) await page.route(`**/api/inspections/1/rounds/1/${name}`, (route) => route.fulfill({ body: wall() }));
  await page.getByTestId('page-space').click();
  await expect(page.getByTestId('map-status')).toContainText('Drag to turn');
  await page.getByTestId('measure-begin').click();
  const asked = page.waitForRequest('**/map/measure');
  await page.getByTestId('measure-middle').press('Enter');
  await expect(result(page)).toHaveText('Tap the other end.');
  await tap(page, 0.55, 0.5, 'space');
  await expect(result(page)).toHaveText('123.4 mm ± 0.8 mm');
  const { points_m } = (await asked).postDataJSON() as { points_m: number[][] };
  expect(points_m[0]![1]).toBeCloseTo(0.6);
  expect(points_m[1]![0]! - points_m[0]![0]!).toBeGreaterThan(0.005);
  await expectTouchable(page);
  await expectAccessible(page);
});
