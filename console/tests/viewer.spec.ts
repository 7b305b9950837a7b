// The pictures: enlarged by wheel, keys, buttons and fingers, with outlines that hide nothing.
import type { Page } from '@playwright/test';
import { openReview } from './review_page';
import { expect, test } from './served';

/** Where a pixel of the pictures is on the screen. */
async function onScreen(page: Page, u: number, v: number): Promise<{ x: number; y: number }> {
  const box = (await page.getByTestId('picture-after').boundingBox())!;
  return { x: box.x + (u / 848) * box.width, y: box.y + (v / 480) * box.height };
}

async function frameOf(page: Page): Promise<{ x: number; y: number; width: number; height: number }> {
  return (await page.getByTestId('picture').boundingBox())!;
}

async function scaleOf(page: Page): Promise<number> {
  return Number(await page.getByTestId('picture').getAttribute('data-scale'));
}

async function expectPictureFills(page: Page): Promise<void> {
  const [frame, picture] = [await frameOf(page), (await page.getByTestId('picture-after').boundingBox())!];
  expect(picture.x).toBeLessThanOrEqual(frame.x + 0.5);
  expect(picture.y).toBeLessThanOrEqual(frame.y + 0.5);
  expect(picture.x + picture.width).toBeGreaterThanOrEqual(frame.x + frame.width - 0.5);
  expect(picture.y + picture.height).toBeGreaterThanOrEqual(frame.y + frame.height - 0.5);
}

test('the wheel enlarges towards the pointer, a drag moves the picture, up to its edge', async ({ console: page }) => {
  await openReview(page);
  const at = await onScreen(page, 212, 360);
  await page.mouse.move(at.x, at.y);
  await page.mouse.wheel(0, -600);
  await expect.poll(() => scaleOf(page)).toBeGreaterThan(2);
  const still = await onScreen(page, 212, 360);
  expect(Math.hypot(still.x - at.x, still.y - at.y), 'the mouse reports whole pixels').toBeLessThan(3);
  await page.mouse.down();
  await page.mouse.move(at.x + 60, at.y + 30, { steps: 4 });
  await page.mouse.up();
  const moved = await onScreen(page, 212, 360);
  expect(moved.x - still.x).toBeCloseTo(60, 0);
  expect(moved.y - still.y).toBeCloseTo(30, 0);
  await page.mouse.down();
  await page.mouse.move(at.x + 900, at.y + 500, { steps: 4 });
  await page.mouse.up();
  await expectPictureFills(page);
  await page.mouse.move(at.x, at.y);
  await page.mouse.wheel(0, 5000);
  await expect.poll(() => scaleOf(page)).toBe(1);
  await expectPictureFills(page);
});

test('keys enlarge and move the picture, and do not turn the camera', async ({ console: page }) => {
  await openReview(page);
  await page.getByTestId('picture').focus();
  await page.keyboard.press('+');
  await page.keyboard.press('+');
  expect(await scaleOf(page)).toBeCloseTo(2.25, 2);
  const before = await onScreen(page, 0, 0);
  await page.keyboard.press('ArrowRight');
  expect((await onScreen(page, 0, 0)).x).toBeLessThan(before.x - 20);
  await page.keyboard.press('-');
  expect(await scaleOf(page)).toBeCloseTo(1.5, 2);
  await page.keyboard.press('0');
  expect(await scaleOf(page)).toBe(1);
  await expect(page.getByTestId('drive-hint'), 'the same keys turn no camera').not.toHaveClass(/warn/);
});

test('the same part is shown of all moments, layers and views; buttons for gloves', async ({ console: page }) => {
  await openReview(page);
  for (let i = 0; i < 3; ++i) await page.getByTestId('zoom-in').click();
  const part = () => page.getByTestId('picture').locator('.zoom-layers').getAttribute('style');
  const before = await part();
  await page.getByTestId('show-menu').click();
  for (const next of ['moment-before', 'moment-blink', 'moment-after', 'picture-depth', 'picture-color', 'review-view-1', 'review-view-0']) {
    await page.getByTestId(next).click();
    expect(await part(), next).toBe(before);
  }
  await page.getByTestId('page-live').click();
  expect(await scaleOf(page), 'the live picture shows something else').toBe(1);
  await page.getByTestId('page-review').click();
  expect(await part()).toBe(before);
  await page.getByTestId('home').click();
  await page.getByTestId('open-1').click();
  await expect.poll(() => scaleOf(page), 'an inspection that is opened begins with the whole picture').toBe(1);
  for (let i = 0; i < 3; ++i) await page.getByTestId('zoom-in').click();
  await page.getByTestId('zoom-out').click();
  expect(await scaleOf(page)).toBeCloseTo(2.25, 2);
  await page.getByTestId('zoom-fit').click();
  expect(await scaleOf(page)).toBe(1);
  await expect(page.getByTestId('zoom-fit')).toBeDisabled();
});

test('outlines are not filled, keep their size on the screen, and a tap selects', async ({ console: page }) => {
  await openReview(page);
  await page.getByTestId('reveal').click();
  const outline = page.getByTestId('box-1').locator('.outline');
  const label = async () => (await page.getByTestId('box-1').locator('text').boundingBox())!;
  expect(await outline.evaluate((rect) => getComputedStyle(rect).fill)).toBe('none');
  expect(await outline.evaluate((rect) => getComputedStyle(rect).vectorEffect)).toBe('non-scaling-stroke');
  const small = await label();
  const top = await onScreen(page, 100, 100);
  expect(small.y + small.height, 'the label stands outside').toBeLessThanOrEqual(top.y + 1);
  await expect(page.getByTestId('picture-changed'), 'nothing glows unless asked for').toHaveCount(0);

  await page.getByTestId('closer').click();
  await expect.poll(() => scaleOf(page)).toBeGreaterThan(3);
  expect((await label()).height).toBeCloseTo(small.height, 0);
  await expect(page.getByTestId('box-1'), 'what fills the frame needs no outline').toHaveClass(/close/);
  const middle = async (u: number, v: number) => {
    const [frame, at] = [await frameOf(page), await onScreen(page, u, v)];
    return Math.hypot(at.x - frame.x - frame.width / 2, at.y - frame.y - frame.height / 2);
  };
  await page.getByTestId('review-view-1').click();
  await expect.poll(() => middle(620, 315), 'the same finding in the other view').toBeLessThan(2);
  await page.getByTestId('review-view-0').click();
  await page.getByTestId('closer').click();
  await expect.poll(() => scaleOf(page)).toBe(1);

  const other = await onScreen(page, 410, 390);
  await page.mouse.click(other.x, other.y);
  await expect(page.getByTestId('finding-3')).toHaveClass(/selected/);
});

test.describe('on a touch screen', () => {
  test.use({ hasTouch: true, viewport: { width: 820, height: 1180 } });

  test('two fingers enlarge, two taps enlarge and reduce', async ({ console: page }) => {
    await openReview(page);
    const at = await onScreen(page, 424, 240);
    const touch = await page.context().newCDPSession(page);
    const fingers = (spread: number) => [{ x: at.x - spread, y: at.y, id: 1 }, { x: at.x + spread, y: at.y, id: 2 }];
    await touch.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: fingers(40) });
    for (const spread of [60, 80, 100, 120]) await touch.send('Input.dispatchTouchEvent', { type: 'touchMove', touchPoints: fingers(spread) });
    await touch.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
    await expect.poll(() => scaleOf(page)).toBeCloseTo(3, 1);
    const still = await onScreen(page, 424, 240);
    expect(Math.hypot(still.x - at.x, still.y - at.y)).toBeLessThan(2);
    expect(await page.evaluate(() => [window.visualViewport?.scale, window.scrollY]), 'the page itself stays').toEqual([1, 0]);
    for (const scale of [1, 3]) {
      await page.touchscreen.tap(at.x, at.y);
      await page.touchscreen.tap(at.x, at.y);
      await expect.poll(() => scaleOf(page)).toBe(scale);
    }
  });
});

test('the live picture is enlarged, too, and measured where it is tapped', async ({ console: page }) => {
  await expect.poll(async () => Number(await page.getByTestId('live').getAttribute('data-frame'))).toBeGreaterThan(0);
  const asked = page.waitForRequest('**/api/measure');
  await page.getByTestId('zoom-in').click();
  await page.getByTestId('zoom-in').click();
  const frame = await frameOf(page);
  await page.mouse.click(frame.x + frame.width / 2, frame.y + 0.75 * frame.height);
  const [point] = ((await asked).postDataJSON() as { points: { u: number; v: number }[] }).points;
  const { width, height } = await page.getByTestId('live').evaluate(({ width, height }: HTMLCanvasElement) => ({ width, height }));
  expect(point!.u / width).toBeCloseTo(0.5, 1);
  expect(point!.v / height).toBeCloseTo(0.5 + 0.25 / 2.25, 1);
});

test('the close-up of a finding is in the view that shows it best, which is named', async ({ console: page }) => {
  await openReview(page);
  await page.getByTestId('reveal').click();
  const card = page.getByTestId('finding-1');
  for (const part of await card.locator('.close-up image').all()) await expect(part).toHaveAttribute('href', /views\/1\/(initial|final)_color\.png$/);
  await expect(card.getByTestId('close-up-view')).toHaveText('In view 2, which shows it best');
  await page.getByTestId('finding-3').getByRole('button').first().click();
  await expect(page.getByTestId('finding-3').locator('.close-up image').first()).toHaveAttribute('href', /views\/0\//);
  await expect(page.getByTestId('finding-3').getByTestId('close-up-view'), 'seen in one view').toHaveCount(0);
});
