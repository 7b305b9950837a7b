// A whole inspection, as a person does it who has never seen the console.
import type { Page } from '@playwright/test';
import { angle, begin, expect, expectAtRest, Served, test } from './served';

/** Nothing is wider than the page. */
async function expectNothingWide(page: Page): Promise<void> {
  expect(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)).toBeLessThanOrEqual(0);
}

test('from the empty list to the last decision, with a reload and a power cut between', async ({ console: page, served }) => {
  await begin(page);
  await expect(page.getByTestId('readiness')).toContainText('Camera: ready');
  await expect(page.getByTestId('readiness')).toContainText('Disk: ready');

  // Two views.
  await page.getByTestId('take').click();
  await expect(page.getByTestId('release')).toBeVisible();
  const ahead = await angle(page, 'pan');
  await page.keyboard.down('ArrowLeft');
  await expect.poll(() => angle(page, 'pan')).toBeGreaterThan(ahead + 5);
  await page.keyboard.up('ArrowLeft');
  await expectAtRest(page);
  await page.getByTestId('add-view').click();
  await expect(page.getByTestId('views').getByRole('listitem')).toHaveCount(2);
  await expect(page.getByTestId('add-view'), 'the same view again would show nothing more').toBeDisabled();

  await page.getByTestId('capture-initial').click();
  await expect(page.getByTestId('progress')).toContainText('View 1 of 2, capture 2 of 2');
  await expect(page.getByTestId('noise')).toContainText('depth noise');
  // In the middle of a capture, the page is loaded again and finds itself there.
  await page.reload();
  await expect(page.getByTestId('work')).toContainText('The baseline is saved', { timeout: 60_000 });

  // The power fails during the work. The baseline is still there.
  const port = served.port;
  await served.kill();
  await expect(page.getByTestId('camera-chip')).toContainText('No connection');
  await served.start(port);
  await expect(page.getByTestId('camera-chip')).toContainText('Camera', { timeout: 30_000 });
  await page.reload();
  await expect(page.getByTestId('work')).toContainText('by Ann');

  await page.getByTestId('simulate-work').click();
  await expect(page.getByTestId('simulate-work')).toContainText('has been done');
  await page.getByTestId('capture-final').click();

  // First with one's own eyes.
  await expect(page.getByTestId('first-look')).toBeVisible({ timeout: 90_000 });
  await expect(page.getByTestId('boxes')).toHaveCount(0);
  await page.getByTestId('moment-blink').click();
  await expect(page.getByTestId('picture-before')).not.toHaveClass(/hidden/);
  await expect(page.getByTestId('picture-before')).toHaveClass(/hidden/);

  // Then what was found, and what could not be inspected.
  await page.getByTestId('reveal').click();
  await expect(page.getByTestId('picture-uninspected')).toBeVisible();
  await expect(page.getByTestId('coverage')).toContainText('was inspected');
  const findings = page.locator('[data-testid^="finding-"]:not([data-testid="finding-summary"])');
  const count = await findings.count();
  expect(count, 'flashlight and screwdriver at least').toBeGreaterThanOrEqual(2);

  // In the map, too.
  await page.getByTestId('page-space').click();
  await expect(page.getByTestId('map-status')).toContainText('Drag to turn', { timeout: 30_000 });
  await page.getByTestId('coloring-change').click();
  await page.getByTestId('page-review').click();

  // Numbers are those of the list, whatever was joined; a finding can be looked at closer.
  await expect(findings.locator('.finding-number').first()).toContainText('1');
  await expect(findings.locator('.finding-number').nth(1)).toContainText('2');
  const width = async () => (await page.getByTestId('picture-after').boundingBox())!.width;
  const before = await width();
  await page.getByTestId('closer').click();
  expect(await width()).toBeGreaterThan(2.9 * before);
  await page.getByTestId('closer').click();

  await page.getByLabel('Note').fill('flashlight, handed to the crew chief');
  await page.getByTestId('verdict-second-look').click();
  await expect(page.locator('.finding.decided').first()).toContainText('handed to the crew chief');
  await expect(page.locator('.finding.decided').first()).toContainText('… Needs a second look');
  await page.getByTestId('finding-1').getByRole('button').first().click();
  await page.getByTestId('finding-1').getByTestId('verdict-debris-removed').click();
  for (let decided = 1; decided < count; ++decided) {
    await expect(page.locator('.finding.decided')).toHaveCount(decided);
    await page.getByTestId('verdict-debris-removed').click();
  }

  // What was removed must be seen to be gone, or the inspection is closed with a note that states why.
  await expect(page.getByTestId('all-decided')).toContainText('capture again to see that it is gone');
  await page.getByTestId('close').click();
  await expect(page.getByTestId('close-confirm')).toBeDisabled();
  await page.getByRole('button', { name: 'Not yet' }).click();
  await page.getByTestId('capture-again').click();
  await expect(page.getByTestId('first-look')).toBeVisible({ timeout: 90_000 });
  await page.getByTestId('reveal').click();
  expect(await findings.count(), 'what was removed is no finding any more').toBeLessThan(count);
  for (let left = await findings.count(); left > 0; --left) {
    await page.getByTestId('verdict-false-alarm').click();
    await expect(page.locator('.finding:not(.decided)')).toHaveCount(left - 1);
  }

  // Both rounds are there, with what was decided.
  await expect(page.getByTestId('round-2')).toContainText('now');
  await expect(page.getByTestId('round-1')).toContainText(`${count} findings: ${count} debris removed`);
  await page.getByTestId('round-1').click();
  await expect(page.getByTestId('earlier-round')).toBeVisible();
  await expect(findings).toHaveCount(count);
  await expect(findings.first()).toContainText('Debris, removed');
  await expect(page.getByTestId('decision')).toHaveCount(0);
  await expect.poll(() => page.getByTestId('picture-after').evaluate((image: HTMLImageElement) => image.naturalWidth)).toBeGreaterThan(800);
  await page.getByRole('button', { name: 'Back to the current round' }).click();

  // A person closes it, by name; nothing can be changed afterwards.
  await expect(page.getByTestId('all-decided')).toContainText('Nothing remains');
  await page.getByTestId('close').click();
  await page.getByTestId('close-form').getByLabel('Your name').fill('Ida');
  await page.getByTestId('close-confirm').click();
  await expect(page.getByTestId('closed')).toContainText('Closed by Ida');
  await expect(page.getByTestId('closed')).toContainText('Signing needs an account');
  await expect(page.getByTestId('capture-again')).toHaveCount(0);

  // The report is a page of its own, with all of its pictures.
  const opened = page.context().waitForEvent('page');
  await page.getByTestId('report').click();
  const report = await opened;
  await expect(report.locator('.verdict')).toContainText('No debris remains in what was inspected');
  await expect(report.locator('.verdict')).toContainText('Closed by Ida');
  expect(await report.locator('.finding').count()).toBeGreaterThanOrEqual(count);
  const missing = await report.locator('img').evaluateAll((images) => (images as HTMLImageElement[]).filter((image) => image.naturalWidth === 0).length);
  expect(missing).toBe(0);
  await expectNothingWide(report);
  await report.close();

  // A closed inspection is not looked at for the first time.
  await page.reload();
  await expect(page.getByTestId('report')).toBeVisible();

  await page.getByTestId('home').click();
  await expect(page.getByTestId('open-1')).toContainText('Closed');
});

test('a baseline of four captures is compared with itself, and nobody has to wait for it', async ({ page }) => {
  const served = new Served();
  await served.start(0, [], 4);
  await page.goto(served.address);
  await begin(page);
  await page.getByTestId('capture-initial').click();
  await expect(page.getByTestId('capture-final')).toBeEnabled({ timeout: 60_000 });
  const check = page.getByTestId('baseline-check');
  await expect(check.getByRole('row')).not.toHaveCount(0, { timeout: 60_000 });
  await expect(check.getByRole('row').nth(1)).toContainText(/\d mm/);
  await expect(check.getByTestId('expected')).toHaveText(/objects of 5 mm are expected to be found in \d+ % of the view, of 10 mm in \d+ %, of 20 mm in \d+ %/);
  await check.getByRole('button').click();
  const picture = check.getByRole('img');
  await expect.poll(() => picture.evaluate((image: HTMLImageElement) => image.naturalWidth)).toBeGreaterThan(800);
  await served.end();
});

test('a capture is cancelled, and goes on where it was', async ({ console: page }) => {
  await begin(page);
  await page.getByTestId('capture-initial').click();
  await page.getByTestId('cancel').click();
  await expect(page.getByTestId('failure')).toContainText('Cancelled');
  await page.getByTestId('capture-initial').click();
  await expect(page.getByTestId('work')).toBeVisible({ timeout: 60_000 });
});

test('pictures of all kinds come, and points in them are measured', async ({ console: page }) => {
  const live = page.getByTestId('live');
  for (const stream of ['depth', 'infrared', 'color']) {
    await page.getByTestId(`stream-${stream}`).click();
    await expect.poll(async () => Number(await live.getAttribute('data-frame'))).toBeGreaterThan(0);
    const before = Number(await live.getAttribute('data-frame'));
    await expect.poll(async () => Number(await live.getAttribute('data-frame'))).toBeGreaterThan(before);
  }
  const box = (await live.boundingBox())!;
  await page.mouse.click(box.x + 0.4 * box.width, box.y + 0.7 * box.height);
  await expect(page.getByTestId('measure')).toContainText(/^\d+ mm ± \d+ mm$/);
  await page.mouse.click(box.x + 0.6 * box.width, box.y + 0.7 * box.height);
  await expect(page.getByTestId('measure')).toContainText(/\d+(\.\d+)? mm ± /);
});
