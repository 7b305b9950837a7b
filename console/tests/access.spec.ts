// Gloves, screens of two sizes, weak eyes, no mouse, and little time to load.
import { readdirSync, readFileSync, statSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { Page } from '@playwright/test';
import { begin, expect, test } from './served';

const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

async function expectAccessible(page: Page): Promise<void> {
  // As a debugger would: the page itself runs no script from elsewhere.
  await page.evaluate(axe);
  const faults = await page.evaluate(async () => {
    const { axe } = window as unknown as { axe: { run: () => Promise<{ violations: { id: string; impact: string; nodes: { html: string }[] }[] }> } };
    const { violations } = await axe.run();
    return violations
      .filter(({ impact }) => impact === 'serious' || impact === 'critical')
      .map(({ id, nodes }) => `${id}: ${nodes[0]?.html}`);
  });
  expect(faults).toEqual([]);
}

async function expectTouchable(page: Page): Promise<void> {
  const small = await page.evaluate(() =>
    [...document.querySelectorAll<HTMLElement>('button, input:not([type=checkbox]), textarea, label.tick')]
      .filter((element) => element.offsetParent !== null)
      .map((element) => ({ element, box: element.getBoundingClientRect() }))
      .filter(({ box }) => box.width < 47.5 || box.height < 47.5)
      .map(({ element, box }) => `${element.outerHTML.slice(0, 80)} ${box.width}x${box.height}`),
  );
  expect(small).toEqual([]);
}

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

test('the first load is under a megabyte', async ({ served, request }) => {
  const folder = process.env['RVA_CONSOLE'] ?? join(dirname(fileURLToPath(import.meta.url)), '..', '..', 'build', 'console');
  let bytes = 0;
  for (const file of readdirSync(folder, { recursive: true, encoding: 'utf8' })) {
    if (file.endsWith('.gz')) bytes += statSync(join(folder, file)).size;
  }
  expect(bytes).toBeGreaterThan(10_000);
  expect(bytes).toBeLessThan(1_000_000);
  const page = await request.get(served.address, { headers: { 'Accept-Encoding': 'gzip' } });
  expect(page.headers()['content-encoding']).toBe('gzip');
});
