// Hold to run: every way of letting go stops the robot.
import { angle, begin, expect, expectAtRest, test } from './served';
import type { Page } from '@playwright/test';

// A controller with the standard mapping, whose sticks the test moves.
async function plugIn(page: Page): Promise<void> {
  await page.evaluate(() => {
    const pad = {
      id: 'Xbox', index: 0, connected: true, mapping: 'standard', timestamp: 0,
      axes: [0, 0, 0, 0], buttons: Array.from({ length: 17 }, () => ({ pressed: false, touched: false, value: 0 })),
    };
    Object.assign(window, { pad });
    navigator.getGamepads = () => [pad as unknown as Gamepad];
  });
}
async function setPad(page: Page, change: { axes?: number[]; connected?: boolean; button?: number }): Promise<void> {
  await page.evaluate((change) => {
    const { pad } = window as unknown as { pad: { axes: number[]; connected: boolean; buttons: { pressed: boolean }[] } };
    if (change.axes) pad.axes = change.axes;
    if (change.connected !== undefined) pad.connected = change.connected;
    if (change.button !== undefined) pad.buttons[change.button]!.pressed = true;
  }, change);
}

const driving = /Turning/;

test.describe('whoever has the controls', () => {
  test.beforeEach(async ({ console: page }) => {
    await begin(page);
    await page.getByTestId('take').click();
    await expect(page.getByTestId('release')).toBeVisible();
  });

  test('turns the camera with keys, and stops it by letting go', async ({ console: page }) => {
    const before = await angle(page, 'pan');
    await page.keyboard.down('ArrowRight');
    await expect(page.getByTestId('drive-hint')).toHaveText(driving);
    await expect.poll(() => angle(page, 'pan')).toBeLessThan(before - 3);
    await page.keyboard.up('ArrowRight');
    await expectAtRest(page);
  });

  test('types names without driving', async ({ console: page }) => {
    const before = await angle(page, 'pan');
    await page.getByTestId('home').click();
    await page.getByLabel('Zone').pressSequentially('wasd');
    expect(await angle(page, 'pan')).toBe(before);
  });

  test('turns it with a controller: dead zone, speed by deflection, unplugging', async ({ console: page }) => {
    await plugIn(page);
    const before = await angle(page, 'pan');
    await setPad(page, { axes: [0.12, 0.1, 0, 0] });
    await page.waitForTimeout(500);
    expect(await angle(page, 'pan'), 'within the dead zone').toBe(before);
    await setPad(page, { axes: [-1, 0, 0, 0] });
    await expect.poll(() => angle(page, 'pan')).toBeGreaterThan(before + 3);
    await setPad(page, { connected: false });
    await expectAtRest(page);
    await setPad(page, { connected: true, axes: [0, 0, 0, 0] });
    await setPad(page, { axes: [0, 1, 0, 0] });
    const tilt = await angle(page, 'tilt');
    await expect.poll(() => angle(page, 'tilt')).toBeLessThan(tilt - 2);
    await setPad(page, { button: 1 });
    await expect(page.getByTestId('drive-hint')).toContainText('Let go of the stick');
    await expectAtRest(page);
    await setPad(page, { axes: [0, 0, 0, 0] });
    await expect(page.getByTestId('drive-hint')).toContainText('Controller ready');
  });

  test('pulls the stick on the screen', async ({ console: page }) => {
    const stick = (await page.getByTestId('stick').boundingBox())!;
    const middle = { x: stick.x + stick.width / 2, y: stick.y + stick.height / 2 };
    const before = await angle(page, 'tilt');
    await page.mouse.move(middle.x, middle.y);
    await page.mouse.down();
    await page.mouse.move(middle.x, middle.y + 60);
    await expect.poll(() => angle(page, 'tilt')).toBeLessThan(before - 3);
    await page.mouse.up();
    await expectAtRest(page);
  });

  test('loses it with the window', async ({ console: page }) => {
    await page.keyboard.down('ArrowLeft');
    await expect(page.getByTestId('drive-hint')).toHaveText(driving);
    await page.evaluate(() => window.dispatchEvent(new Event('blur')));
    await expectAtRest(page);
  });

  test('stops, and must let go before it turns again', async ({ console: page }) => {
    await page.keyboard.down('ArrowLeft');
    await expect(page.getByTestId('drive-hint')).toHaveText(driving);
    await page.getByTestId('stop').dispatchEvent('click');
    await expect(page.getByTestId('drive-hint')).toContainText('Let go of the stick');
    await expectAtRest(page);
    await page.keyboard.up('ArrowLeft');
    await expect(page.getByTestId('drive-hint')).toContainText('Pull the stick');
  });

  test('comes to the end of the way and is told', async ({ console: page }) => {
    await page.keyboard.down('ArrowUp');
    await expect(page.getByTestId('drive-hint')).toContainText('End of the way');
    await page.keyboard.up('ArrowUp');
    expect(await angle(page, 'tilt')).toBeLessThanOrEqual(9);
  });

  test('keeps the controls when the page is loaded again', async ({ console: page }) => {
    await page.reload();
    await expect(page.getByTestId('release')).toBeVisible();
  });
});

test('one drives, others watch, stop and take over', async ({ console: ann, served, browser }) => {
  await begin(ann);
  await ann.getByTestId('take').click();
  await expect(ann.getByTestId('release')).toBeVisible();

  const bob = await (await browser.newContext()).newPage();
  await bob.goto(served.address);
  await bob.getByTestId('open-1').click();
  await expect(bob.getByTestId('take-over')).toContainText('Ann drives');
  await expect(bob.getByTestId('stick')).toHaveAttribute('aria-disabled', 'true');

  await ann.bringToFront();
  await ann.keyboard.down('ArrowLeft');
  await expect(ann.getByTestId('drive-hint')).toHaveText(driving);
  await bob.getByTestId('stop').dispatchEvent('click');
  await expect(ann.getByTestId('drive-hint')).toContainText('Let go of the stick');
  await ann.keyboard.up('ArrowLeft');

  await bob.bringToFront();
  await bob.getByTestId('take-over').click();
  await bob.getByTestId('take-over-yes').click();
  await expect(bob.getByTestId('release')).toBeVisible();
  await expect(ann.getByTestId('release')).toHaveCount(0);
  await expect(ann.getByTestId('take-over')).toBeVisible();
  await expect(ann.getByTestId('trouble'), 'she is told why').toContainText('Somebody has taken over');
  await ann.keyboard.press('ArrowLeft');
  await expect(ann.getByTestId('drive-hint'), 'and what to do').toHaveClass(/warn/);
});

test('a line that breaks while the stick is held stops the robot', async ({ console: page, served, browser }) => {
  await begin(page);
  await page.getByTestId('take').click();
  const other = await (await browser.newContext()).newPage();
  await other.goto(served.address);
  await page.bringToFront();
  await page.keyboard.down('ArrowLeft');
  await expect(page.getByTestId('drive-hint')).toHaveText(driving);
  // The page freezes: nothing is said any more, and nothing is closed.
  await page.evaluate(() => {
    WebSocket.prototype.send = () => undefined;
  });
  await expectAtRest(other);
});
