// The 3D view by keyboard.
import type { Page } from '@playwright/test';
import { expectAccessible, expectTouchable } from './accessibility';
import { openReview, wall } from './review_page';
import { angle, expect, test } from './served';

async function openMap(page: Page): Promise<void> {
  for (const name of ['map', 'changes']) await page.route(`**/api/inspections/1/rounds/1/${name}`, (route) => route.fulfill({ body: wall() }));
  await page.getByTestId('page-space').click();
  await expect(page.getByTestId('map-status')).toBeVisible();
}

test('keys turn, move and zoom the map, show all of it again, and do not turn the camera', async ({ console: page }) => {
  await openReview(page);
  // With the controls taken, the same keys would turn the camera.
  await page.getByTestId('page-live').click();
  await page.getByTestId('take').click();
  await expect(page.getByTestId('release')).toBeVisible();
  const pan = await angle(page, 'pan');
  await openMap(page);
  const space = page.getByTestId('space');
  const looks = async () => (await space.screenshot()).toString('base64');
  for (let i = 0; i < 60 && !(await space.evaluate((element) => element === document.activeElement)); ++i) await page.keyboard.press('Tab');
  await expect(space).toBeFocused();
  const border = await space.evaluate((element) => getComputedStyle(element, '::before').borderTopWidth);
  expect(border, 'the focus is visible').toBe('3px');
  const whole = await looks();
  const seen = new Set([whole]);
  for (const key of ['ArrowLeft', 'ArrowUp', 'Shift+ArrowRight', 'Shift+ArrowDown', '+']) {
    await page.keyboard.press(key);
    await expect.poll(async () => seen.has(await looks()), key).toBe(false);
    seen.add(await looks());
  }
  for (const key of ['-', 'Shift+ArrowUp', 'Shift+ArrowLeft', 'ArrowDown', 'ArrowRight']) await page.keyboard.press(key);
  await page.keyboard.press('0');
  await expect.poll(looks).toBe(whole);
  await expectTouchable(page);
  await expectAccessible(page);
  await page.getByTestId('page-live').click();
  expect(await angle(page, 'pan')).toBe(pan);
});

test('the keys are listed behind the question mark', async ({ console: page }) => {
  await openReview(page);
  await openMap(page);
  await page.getByTestId('glossary-open').click();
  await expect(page.getByTestId('key-turn')).toContainText('turn the map');
  await expect(page.getByTestId('key-zoom')).toBeVisible();
  await expect(page.getByTestId('key-region')).toHaveCount(0);
  await expectAccessible(page);
  await page.keyboard.press('Escape');
  await page.getByTestId('language').click();
  await page.getByTestId('glossary-open').click();
  await expect(page.getByTestId('key-turn')).toContainText('Pfeiltasten: drehen die Karte');
});
