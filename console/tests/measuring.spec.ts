// Measuring in the live picture, in those of the review and in the map, with uncertainties.
import type { Page } from '@playwright/test';
import { expectAccessible, expectTouchable } from './accessibility';
import { begin, expect, test } from './served';

const quantity = /\d(\.\d+)? mm ± \d+(\.\d+)? mm/;
const result = (page: Page) => page.getByTestId('measure-result');

async function tap(page: Page, x: number, y: number, testId = 'picture'): Promise<void> {
  const box = (await page.getByTestId(testId).boundingBox())!;
  await page.mouse.click(box.x + x * box.width, box.y + y * box.height);
  // A second tap soon and nearby would be a double tap.
  await page.waitForTimeout(400);
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
  await expect(result(page)).toContainText('three points of the surface');
  for (const [x, y] of [[0.35, 0.62], [0.65, 0.62], [0.5, 0.8]] as const) await tap(page, x, y);
  // By keyboard, what is in the middle.
  await page.getByTestId('picture').focus();
  await page.keyboard.press('+');
  await page.keyboard.press('ArrowDown');
  await page.getByTestId('measure-middle').press('Enter');
  await expect(result(page)).toContainText(/mm ± .* (above|below) the surface/);
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

test('before and after the work, and in the map', async ({ console: page }) => {
  await begin(page);
  await page.getByTestId('capture-initial').click();
  await expect(page.getByTestId('work')).toBeVisible({ timeout: 90_000 });
  await page.getByTestId('simulate-work').click();
  await page.getByTestId('capture-final').click();
  await expect(page.getByTestId('first-look')).toBeVisible({ timeout: 120_000 });

  for (const moment of ['after', 'before']) {
    await page.getByTestId(`moment-${moment}`).click();
    await page.getByTestId('measure-begin').click();
    const asked = page.waitForRequest((request) => request.url().endsWith('/measure') && request.postData()!.includes('length'));
    await tap(page, 0.4, 0.7);
    await tap(page, 0.6, 0.7);
    expect((await asked).postDataJSON()).toMatchObject({ tool: 'length', side: moment === 'after' ? 'final' : 'initial' });
    await expect(result(page)).toHaveText(quantity);
    await page.getByTestId('tool-profile').click();
    await tap(page, 0.4, 0.7);
    await tap(page, 0.6, 0.7);
    await expect(page.getByTestId('profile')).toBeVisible();
    await expectTouchable(page);
    await expectAccessible(page);
    await page.getByTestId('measure-leave').click();
  }

  await page.getByTestId('page-space').click();
  await expect(page.getByTestId('map-status')).toContainText('Drag to turn', { timeout: 30_000 });
  await page.getByTestId('measure-begin').click();
  await page.getByTestId('measure-middle').press('Enter');
  await expect(result(page)).toHaveText('Tap the other end.');
  await tap(page, 0.55, 0.6, 'space');
  await expect(result(page)).toHaveText(/mm ± |no view measures/);
  await expectTouchable(page);
  await expectAccessible(page);
});
