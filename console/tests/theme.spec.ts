// The dark and the bright theme, and what must not look like an alarm, or like the absence of one.
import type { Page } from '@playwright/test';
import { expectAccessible } from './accessibility';
import { openReview } from './review_page';
import { expect, test } from './served';

const ground = (page: Page) => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
const dark = 'rgb(16, 21, 28)';
const bright = 'rgb(255, 255, 255)';

test('the theme is that of the system until one is chosen, which is kept', async ({ console: page }) => {
  await page.emulateMedia({ colorScheme: 'light' });
  await expect.poll(() => ground(page)).toBe(bright);
  await page.emulateMedia({ colorScheme: 'dark' });
  await expect.poll(() => ground(page)).toBe(dark);
  await page.getByTestId('theme').click();
  await expect.poll(() => ground(page)).toBe(bright);
  await expect(page.getByTestId('theme')).toHaveAttribute('aria-checked', 'true');
  await page.reload();
  await expect(page.getByTestId('theme')).toHaveAttribute('aria-checked', 'true');
  expect(await ground(page)).toBe(bright);
  await expect(page.locator('meta[name="theme-color"]')).toHaveAttribute('content', '#f2f4f7');
});

test('the bright theme is accessible on every page', async ({ console: page }) => {
  await page.emulateMedia({ colorScheme: 'light' });
  await expectAccessible(page);
  await openReview(page);
  await page.getByTestId('reveal').click();
  await expectAccessible(page);
  await page.getByTestId('page-regions').click();
  await expectAccessible(page);
});

test('depth has its scale, with a unit, beside the picture', async ({ console: page }) => {
  await page.setViewportSize({ width: 820, height: 1180 });
  await page.getByTestId('stream-depth').click();
  const scale = page.getByTestId('depth-scale');
  await expect(scale).toContainText(/≤ \d\.\d\d m.*≥ \d\.\d\d m/);
  const [box, picture] = [(await scale.boundingBox())!, (await page.getByTestId('picture').boundingBox())!];
  expect(box.y + box.height).toBeLessThanOrEqual(picture.y);
  await page.getByTestId('stream-color').click();
  await expect(scale).toHaveCount(0);
});

test('no chip is green once the connection is lost', async ({ console: page, served }) => {
  const { port } = served;
  for (const chip of ['robot-chip', 'camera-chip']) await expect(page.getByTestId(chip)).toHaveClass(/good/);
  await served.kill();
  for (const chip of ['robot-chip', 'camera-chip']) await expect(page.getByTestId(chip)).not.toHaveClass(/good/);
  await served.start(port);
});

test('without a robot, nothing is cut off', async ({ served, page }) => {
  await page.routeWebSocket(/api\/live/, (socket) => {
    const server = socket.connectToServer();
    server.onMessage((message) => {
      if (typeof message !== 'string' || !message.includes('"robot"')) return socket.send(message);
      const { robot: _, ...rest } = JSON.parse(message) as { robot?: unknown };
      socket.send(JSON.stringify(rest));
    });
  });
  for (const viewport of [{ width: 820, height: 1180 }, { width: 1180, height: 820 }]) {
    await page.setViewportSize(viewport);
    await page.goto(served.address);
    const note = page.getByText('No robot: the camera does not move.');
    await expect(note).toBeVisible();
    const box = (await note.boundingBox())!;
    expect(box.y + box.height).toBeLessThanOrEqual(viewport.height);
    expect(await note.evaluate((text) => text.scrollWidth <= text.clientWidth)).toBe(true);
    const label = await page.getByTestId('picture').boundingBox();
    expect(label!.y + label!.height).toBeLessThanOrEqual(viewport.height - 40);
  }
});

test('a notice is no alarm', async ({ console: page }) => {
  await page.route('**/api/inspections', (route) => (route.request().method() === 'POST' ? route.fulfill({ status: 409, json: { error: { code: 'busy', message: 'Ann is driving.' } } }) : route.continue()));
  for (const field of ['Aircraft', 'Zone', 'Your name']) await page.getByLabel(field).fill('1');
  await page.getByTestId('begin').click();
  const notice = page.getByTestId('trouble');
  await expect(notice).toContainText('Ann is driving.');
  const [r, g] = await notice.evaluate((element) => getComputedStyle(element).backgroundColor.match(/\d+/g)!.map(Number));
  expect(r! - g!, 'not red').toBeLessThan(20);
});
