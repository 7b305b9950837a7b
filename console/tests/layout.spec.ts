// What is needed for the work is on the screen, without scrolling and large enough for gloves, however it is held.
import type { Page } from '@playwright/test';
import { expectAccessible } from './accessibility';
import { openReview } from './review_page';
import { begin, expect, test } from './served';

const sizes = { upright: { width: 820, height: 1180 }, landscape: { width: 1180, height: 820 }, laptop: { width: 1280, height: 800 } };
const glove_px = 56;

async function boxOf(page: Page, selector: string): Promise<{ x: number; y: number; width: number; height: number }> {
  return (await page.locator(selector).first().boundingBox())!;
}

/** Nothing lies over it, and nothing of it is cut off. */
async function expectInReach(page: Page, ...testIds: string[]): Promise<void> {
  for (const testId of testIds) {
    const element = page.getByTestId(testId).first();
    const box = (await element.boundingBox())!;
    expect(box.height, testId).toBeGreaterThanOrEqual(glove_px - 0.5);
    const covered = await element.evaluate((button) => {
      const { left, right, top, bottom } = button.getBoundingClientRect();
      const [x, y, inset] = [(left + right) / 2, (top + bottom) / 2, 4];
      const points = [[x, top + inset], [x, bottom - inset], [left + inset, y], [right - inset, y]] as const;
      return points.some((point) => !button.contains(document.elementFromPoint(...point)));
    });
    expect(covered, `${testId} is covered or beyond the screen`).toBe(false);
  }
}

async function expectArranged(page: Page, size: { width: number; height: number }, panel_share: number): Promise<void> {
  const [picture, panel] = [await boxOf(page, '.picture-fit'), await boxOf(page, 'aside')];
  if (size.width > size.height) {
    expect(panel.x).toBeGreaterThanOrEqual(picture.x + picture.width);
    expect(picture.height).toBeGreaterThan(0.5 * size.height);
    return;
  }
  expect(picture.width).toBeGreaterThan(0.98 * size.width);
  expect(panel.y).toBeGreaterThanOrEqual(picture.y + picture.height);
  expect(panel.height).toBeGreaterThanOrEqual(panel_share * size.height);
}

for (const [name, size] of Object.entries(sizes)) {
  test.describe(name, () => {
    test.use({ viewport: size });

    test('the next step is in reach while the camera is at rest and while somebody drives', async ({ console: page }) => {
      await expectInReach(page, 'begin', 'stop');
      await begin(page);
      await expectArranged(page, size, 0.4);
      await expectInReach(page, 'capture-initial', 'stop', 'take', 'stream-depth', 'zoom-in', 'page-live');
      await expect(page.getByTestId('stick'), 'nobody drives').toHaveCount(0);
      expect((await boxOf(page, 'footer')).height).toBeLessThan(72);
      await page.getByTestId('take').click();
      await expect(page.getByTestId('stick')).toBeVisible();
      await expectArranged(page, size, 0.3);
      await expectInReach(page, 'capture-initial', 'stop', 'release');
      await page.getByTestId('release').click();
      await expect(page.getByTestId('stick')).toHaveCount(0);
    });

    test('in the review, pictures and decisions are in reach together', async ({ console: page }) => {
      await openReview(page);
      await expectInReach(page, 'reveal', 'stop', 'moment-blink', 'zoom-fit', 'review-view-1');
      await page.getByTestId('reveal').click();
      await expectArranged(page, size, 0.4);
      await expectInReach(page, 'verdict-debris-removed', 'verdict-second-look', 'closer', 'show-menu', 'page-space', 'stop');
      await page.getByTestId('show-menu').click();
      await expectInReach(page, 'picture-depth', 'show-findings', 'show-glow', 'show-uninspected');
      await page.getByTestId('view-notes').locator('summary').click();
      await expect(page.getByTestId('coverage')).toBeInViewport();
      await expectAccessible(page);
    });
  });
}
