// The page on which regions are drawn, for tests: positions are in pixels of the baseline's picture.
import { expect, type Page } from '@playwright/test';
import type { Corner, Inspection } from '../src/types';

export async function openEditor(page: Page): Promise<void> {
  await page.getByTestId('page-regions').click();
  await expect(page.getByTestId('regions')).toBeVisible();
}

/** Where a pixel is on the screen. */
export async function onScreen(page: Page, [u, v]: Corner): Promise<{ x: number; y: number }> {
  const box = (await page.getByTestId('regions').boundingBox())!;
  const width = await page.getByTestId('regions-image').evaluate((image) => (image as HTMLImageElement).naturalWidth);
  const scale = box.width / width;
  return { x: box.x + (u + 0.5) * scale, y: box.y + (v + 0.5) * scale };
}

export async function drag(page: Page, from: Corner, to: Corner): Promise<void> {
  const [start, end] = [await onScreen(page, from), await onScreen(page, to)];
  await page.mouse.move(start.x, start.y);
  await page.mouse.down();
  await page.mouse.move((start.x + end.x) / 2, (start.y + end.y) / 2);
  await page.mouse.move(end.x, end.y);
  await page.mouse.up();
}

/** The corners of a region as it is drawn. */
export async function cornersOf(page: Page, region: number): Promise<Corner[]> {
  const points = await page.getByTestId(`region-${region}`).locator('polygon').first().getAttribute('points');
  return points!.split(' ').map((corner) => corner.split(',').map(Number) as Corner);
}

/** The first inspection as the server has it. */
export function inspectionOf(page: Page): Promise<Inspection> {
  return page.evaluate(async () => (await (await fetch('/api/inspections/1')).json()) as Inspection);
}

/**
 * Loads the console at an address within it. The page before is left first: one that is still shown writes the address of
 * what it shows, which may be over the one that is asked for.
 */
export async function openAt(page: Page, hash: string): Promise<void> {
  const { origin } = new URL(page.url());
  await page.goto('about:blank');
  await page.goto(`${origin}/${hash}`);
}

/** The page is shown an inspection other than the server's, and pictures of one colour. */
export async function standIn(page: Page, part: Partial<Inspection>, withColor = true): Promise<void> {
  const inspection = { ...(await inspectionOf(page)), ...part };
  const body = '<svg xmlns="http://www.w3.org/2000/svg" width="848" height="480"><rect width="848" height="480" fill="#567"/></svg>';
  await page.route('**/api/inspections/1', (route) => route.fulfill({ json: inspection }));
  await page.route(/api\/inspections\/1\/.*\.png/, (route) =>
    withColor || !route.request().url().includes('color.png') ? route.fulfill({ contentType: 'image/svg+xml', body }) : route.fulfill({ status: 404, json: {} }),
  );
  // With no page in the address, the one of the inspection's step is shown.
  await openAt(page, '#/inspections/1');
}
