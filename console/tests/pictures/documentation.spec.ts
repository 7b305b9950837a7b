// Writes the pictures of docs/console.md while it performs the inspection of script/demo: `npm run pictures`.
import type { Page } from '@playwright/test';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { angle, begin, expect, expectAtRest, Served, test } from '../served';

const images = join(dirname(fileURLToPath(import.meta.url)), '..', '..', '..', 'docs', 'images');
const laptop = { width: 1280, height: 800 };
const upright = { width: 820, height: 1180 };
const capture_ms = 300_000;

test.setTimeout(900_000);

async function shootNow(page: Page, name: string): Promise<void> {
  await page.screenshot({ path: join(images, `console-${name}.jpg`), type: 'jpeg', quality: 82 });
}

async function shoot(page: Page, name: string): Promise<void> {
  // Pictures that are still being loaded or faded in would be missing.
  await page.waitForTimeout(3000);
  await shootNow(page, name);
}

async function tap(page: Page, x: number, y: number): Promise<void> {
  const box = (await page.getByTestId('picture').boundingBox())!;
  await page.mouse.click(box.x + x * box.width, box.y + y * box.height);
  // A second tap soon and nearby would be a double tap.
  await page.waitForTimeout(400);
}

async function turnLeft(page: Page, by_deg: number): Promise<void> {
  const from_deg = await angle(page, 'pan');
  await page.keyboard.down('ArrowLeft');
  await expect.poll(() => angle(page, 'pan')).toBeGreaterThan(from_deg + by_deg);
}

async function measureProfile(page: Page): Promise<void> {
  await page.getByTestId('measure-begin').click();
  await page.getByTestId('tool-profile').click();
  await tap(page, 0.3, 0.62);
  await tap(page, 0.75, 0.62);
  await expect(page.getByTestId('profile')).toBeVisible();
  await shoot(page, 'measure');
  await page.keyboard.press('Escape');
}

test('an inspection as in the demonstration', async ({ page }) => {
  const served = new Served();
  await served.start(0, ['--seed', '1520001'], 8, 40);
  try {
    await page.setViewportSize(laptop);
    await page.goto(served.address);
    await begin(page);
    await expect(page.getByTestId('readiness')).toContainText('Camera: ready', { timeout: 60_000 });
    await page.getByTestId('take').click();
    await expect(page.getByTestId('release')).toBeVisible();
    await turnLeft(page, 4);
    await shootNow(page, 'drive');
    await page.keyboard.up('ArrowLeft');
    await expectAtRest(page);
    await page.getByTestId('add-view').click();
    await expect(page.getByTestId('views').getByRole('listitem')).toHaveCount(2);
    await measureProfile(page);
    // Otherwise a notice that they were handed back would be in the pictures.
    await page.getByTestId('release').click();

    await page.getByTestId('capture-initial').click();
    await expect(page.getByTestId('work')).toContainText('The baseline is saved', { timeout: capture_ms });
    await page.getByTestId('simulate-work').click();
    await expect(page.getByTestId('simulate-work')).toContainText('has been done');
    await page.getByTestId('capture-final').click();
    await expect(page.getByTestId('first-look')).toBeVisible({ timeout: capture_ms });

    await page.getByTestId('reveal').click();
    await expect(page.getByTestId('picture-uninspected')).toBeVisible();
    await shoot(page, 'review');
    await page.setViewportSize(upright);
    await shoot(page, 'tablet');
    await page.setViewportSize(laptop);

    await page.getByTestId('show-menu').click();
    await page.getByTestId('show-uninspected').click();
    await page.getByTestId('findable-10').click();
    await expect(page.getByTestId('findable-legend')).toBeVisible();
    await page.getByTestId('show-menu').click();
    await shoot(page, 'findable');

    await page.getByTestId('page-space').click();
    await expect(page.getByTestId('map-status')).toContainText('Drag to turn', { timeout: 60_000 });
    await page.getByTestId('coloring-change').click();
    await shoot(page, 'space');
  } finally {
    await served.end();
  }
});
