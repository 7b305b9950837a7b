// Gloves, screens of two sizes, weak eyes, no mouse, and little time to load.
import { readdirSync, statSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { Page } from '@playwright/test';
import { expectAccessible, expectTouchable } from './accessibility';
import { begin, expect, test } from './served';

async function expectNothingCutOff(page: Page): Promise<void> {
  const beyond = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
  expect(beyond).toBe(0);
  const stop = (await page.getByTestId('stop').boundingBox())!;
  const size = page.viewportSize()!;
  expect(stop.x + stop.width).toBeLessThanOrEqual(size.width);
  expect(stop.y + stop.height).toBeLessThanOrEqual(size.height);
}

for (const [name, viewport] of Object.entries({ laptop: { width: 1280, height: 800 }, tablet: { width: 820, height: 1180 } })) {
  test(`every page on a ${name} is for gloves, weak eyes and keyboards`, async ({ console: page }) => {
    await page.setViewportSize(viewport);
    await page.emulateMedia({ colorScheme: name === 'laptop' ? 'dark' : 'light' });
    const check = async () => {
      await expectTouchable(page);
      await expectNothingCutOff(page);
      await expectAccessible(page);
    };
    await check();
    await begin(page);
    await expect(page.getByTestId('readiness')).toContainText('Disk');
    await check();
    await page.getByTestId('capture-initial').click();
    await expect(page.getByTestId('work')).toBeVisible({ timeout: 60_000 });
    await check();
    await page.getByTestId('simulate-work').click();
    await page.getByTestId('capture-final').click();
    await expect(page.getByTestId('first-look')).toBeVisible({ timeout: 60_000 });
    await page.getByTestId('reveal').click();
    await check();
  });
}

test('an inspection is begun by keyboard alone', async ({ console: page }) => {
  await page.getByLabel('Aircraft').focus();
  for (const text of ['N123AB', 'Left wing', 'WO 7', 'Ann']) {
    await page.keyboard.type(text);
    if (text !== 'Ann') await page.keyboard.press('Tab');
  }
  await page.keyboard.press('Enter');
  await expect(page.getByTestId('capture-initial')).toBeVisible();
  for (let i = 0; i < 60 && !(await page.getByTestId('capture-initial').evaluate((button) => button === document.activeElement)); ++i)
    await page.keyboard.press('Tab');
  await page.keyboard.press('Enter');
  await expect(page.getByTestId('progress')).toBeVisible();
});

test('the first load is under 200 KB, and the whole console under a megabyte', async ({ served, request }) => {
  const folder = process.env['RVA_CONSOLE'] ?? join(dirname(fileURLToPath(import.meta.url)), '..', '..', 'build', 'console');
  const files = readdirSync(folder, { recursive: true, encoding: 'utf8' }).filter((file) => file.endsWith('.gz'));
  const bytesOf = (names: string[]) => names.reduce((sum, file) => sum + statSync(join(folder, file)).size, 0);
  // What is loaded when it is needed: the 3D view, and languages other than English.
  const first = files.filter((file) => !/(SpaceView|de)-[^/]*$/.test(file));
  expect(first.length).toBeLessThan(files.length);
  expect(bytesOf(first)).toBeGreaterThan(10_000);
  expect(bytesOf(first)).toBeLessThan(200_000);
  expect(bytesOf(files)).toBeLessThan(1_000_000);
  const page = await request.get(served.address, { headers: { 'Accept-Encoding': 'gzip' } });
  expect(page.headers()['content-encoding']).toBe('gzip');
});
