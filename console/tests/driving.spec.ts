// Hold to run: every way of letting go stops the robot.
import { expectAccessible, expectTouchable } from './accessibility';
import { angle, begin, expect, expectAtRest, test } from './served';
import type { Page } from '@playwright/test';

interface StandIn {
  id?: string;
  mapping?: string;
  axes?: number[];
}

// Controllers whose sticks the test moves, with the standard mapping unless stated otherwise.
async function plugIn(page: Page, ...standIns: StandIn[]): Promise<void> {
  await page.evaluate((standIns) => {
    const pads = standIns.map(({ id, mapping, axes }, index) => ({
      id: id ?? 'Xbox', index, connected: true, mapping: mapping ?? 'standard', timestamp: 0, axes: axes ?? [0, 0, 0, 0],
      buttons: Array.from({ length: 17 }, () => ({ pressed: false, touched: false, value: 0 })),
    }));
    Object.assign(window, { pads });
    navigator.getGamepads = () => pads as unknown as Gamepad[];
  }, standIns.length > 0 ? standIns : [{}]);
}
async function setPad(page: Page, change: { axes?: number[]; connected?: boolean; button?: number; released?: number }, at = 0): Promise<void> {
  await page.evaluate(([change, at]) => {
    const { pads } = window as unknown as { pads: { axes: number[]; connected: boolean; buttons: { pressed: boolean }[] }[] };
    const pad = pads[at]!;
    if (change.axes) pad.axes = change.axes;
    if (change.connected !== undefined) pad.connected = change.connected;
    if (change.button !== undefined) pad.buttons[change.button]!.pressed = true;
    if (change.released !== undefined) pad.buttons[change.released]!.pressed = false;
  }, [change, at] as const);
}

// The drive messages that the page has sent since then.
async function recordDriving(page: Page): Promise<() => Promise<{ pan: number; tilt: number }[]>> {
  await page.evaluate(() => {
    const driven: { pan: number; tilt: number }[] = [];
    Object.assign(window, { driven });
    const send = WebSocket.prototype.send;
    WebSocket.prototype.send = function (data) {
      const message = JSON.parse(String(data)) as { type: string; pan: number; tilt: number };
      if (message.type === 'drive') driven.push({ pan: message.pan, tilt: message.tilt });
      send.call(this, data);
    };
  });
  return () => page.evaluate(() => (window as unknown as { driven: { pan: number; tilt: number }[] }).driven);
}

const driving = /Turning/;

test.describe('with the controls', () => {
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

  test('turns it with the controller that moves, whichever is first', async ({ console: page }) => {
    await plugIn(page, { id: 'Idle' }, { id: 'Real' });
    const tilt = await angle(page, 'tilt');
    await setPad(page, { axes: [0, 1, 0, 0] }, 1);
    await expect.poll(() => angle(page, 'tilt')).toBeLessThan(tilt - 3);
    const pan = await angle(page, 'pan');
    await setPad(page, { axes: [-1, 0, 0, 0] }, 0);
    await expect.poll(() => angle(page, 'pan'), 'the other one takes over').toBeGreaterThan(pan + 3);
    await setPad(page, { button: 1 }, 1);
    await expect(page.getByTestId('drive-hint'), 'and each stops').toContainText('Let go of the stick');
  });

  test('never creeps with a worn controller, and drives on after a stop', async ({ console: page }) => {
    const driven = await recordDriving(page);
    await plugIn(page, { axes: [0.16, 0.2, 0, 0] });
    await expect(page.getByTestId('drive-hint')).toContainText('Controller ready');
    await page.getByTestId('stop').dispatchEvent('click');
    await expect(page.getByTestId('drive-hint')).toContainText('Controller ready');
    await expect.poll(async () => (await driven()).length, 'a released stick is reported, which arms').toBeGreaterThan(0);
    expect(new Set((await driven()).map(({ pan, tilt }) => `${pan} ${tilt}`))).toEqual(new Set(['0 0']));
    const before = await angle(page, 'pan');
    await page.keyboard.down('ArrowLeft');
    await expect.poll(() => angle(page, 'pan')).toBeGreaterThan(before + 3);
    await page.keyboard.up('ArrowLeft');
    await expectAtRest(page);
  });

  test('drives by keyboard beside a controller whose stick is stuck', async ({ console: page }) => {
    await plugIn(page, { id: 'Stuck', axes: [1, 0, 0, 0] });
    await page.getByTestId('stop').dispatchEvent('click');
    await expect(page.getByTestId('controller-notice')).toContainText('Stuck is ignored');
    await expect(page.getByTestId('drive-hint')).toContainText('Pull the stick');
    const before = await angle(page, 'pan');
    await page.keyboard.down('ArrowLeft');
    await expect.poll(() => angle(page, 'pan')).toBeGreaterThan(before + 3);
    await page.keyboard.up('ArrowLeft');
    await setPad(page, { axes: [0, 0, 0, 0] });
    await expect(page.getByTestId('drive-hint'), 'it has come to rest').toContainText('Controller ready');
    await expect(page.getByTestId('controller-notice')).toHaveCount(0);
  });

  test('teaches a controller without the standard mapping, which is kept until it is forgotten', async ({ console: page }) => {
    const odd = { id: '0079-0006-Odd', mapping: '', axes: [0, 0, -1, 0, 0, -1] };
    const step = page.getByTestId('teach-step');
    await plugIn(page, odd);
    await expect(page.getByTestId('controller-notice')).toContainText('Odd does not have the standard mapping');
    await page.getByTestId('controller-open').click();
    await page.getByTestId('teach-begin').click();
    await page.getByTestId('teach-cancel').click();
    await expect(page.getByTestId('controller-0')).toContainText('No standard mapping');

    await page.getByTestId('teach-begin').click();
    await expect(step).toContainText('to the right');
    await setPad(page, { axes: [0, 0, -1, 1, 0, -1] });
    await expect(step).toContainText('Let go');
    await setPad(page, { axes: odd.axes });
    await expect(step).toContainText('up');
    await setPad(page, { axes: [0, 0, -1, 0, -1, -1] });
    await expect(step).toContainText('Let go');
    await setPad(page, { axes: odd.axes });
    await expect(step).toContainText('Press the button');
    await setPad(page, { button: 5 });
    await expect(step).toContainText('Let go');
    await setPad(page, { released: 5 });
    await expect(page.getByTestId('controller-0')).toContainText('Ready');

    await page.reload();
    await plugIn(page, odd);
    await expect(page.getByTestId('drive-hint')).toContainText('Controller ready');
    const before = await angle(page, 'pan');
    // A page that is still busy loading may fall silent, which stops the robot: then the stick is pushed again.
    await expect(async () => {
      await setPad(page, { axes: odd.axes });
      await expect(page.getByTestId('drive-hint')).toContainText('Controller ready');
      await setPad(page, { axes: [0, 0, -1, -1, 0, -1] });
      await expect.poll(() => angle(page, 'pan'), { timeout: 4000 }).toBeGreaterThan(before + 3);
    }).toPass();
    await setPad(page, { button: 5 });
    await expect(page.getByTestId('drive-hint')).toContainText('Let go of the stick');
    await setPad(page, { axes: odd.axes });

    await page.getByTestId('controller-open').click();
    await page.getByTestId('teach-forget').click();
    await expect(page.getByTestId('controller-notice')).toContainText('does not have the standard mapping');
  });

  test('sets a dead zone, which is kept', async ({ console: page }) => {
    await page.getByTestId('controller-open').click();
    await page.getByTestId('dead-zone').fill('0.4');
    await expect(page.getByTestId('controller-settings')).toContainText('40 %');
    await plugIn(page);
    await expectTouchable(page);
    await expectAccessible(page);
    await page.reload();
    await page.getByTestId('controller-open').click();
    await expect(page.getByTestId('dead-zone')).toHaveValue('0.4');
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

  test('a limit is reported when the camera reaches it', async ({ console: page }) => {
    await page.keyboard.down('ArrowUp');
    await expect(page.getByTestId('drive-hint')).toContainText('Limit reached');
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
  await expect(bob.getByTestId('take-over')).toContainText('Ann is driving');
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
  await expect(ann.getByTestId('trouble'), 'the reason is shown').toContainText('Somebody has taken over');
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
  // The page freezes: it sends nothing any more, and closes nothing.
  await page.evaluate(() => {
    WebSocket.prototype.send = () => undefined;
  });
  await expectAtRest(other);
});
