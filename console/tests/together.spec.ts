// Two people look at the same live picture: what one freezes, keeps and points at.
import { expectAccessible, expectTouchable } from './accessibility';
import { begin, expect, test } from './served';

test('a frozen picture stands still, is measured, and is kept with a note', async ({ console: page }) => {
  await begin(page);
  await expect.poll(async () => Number(await page.getByTestId('live').getAttribute('data-frame'))).toBeGreaterThan(0);
  await page.getByTestId('freeze').click();
  await expect(page.getByTestId('frozen')).toContainText('Frozen at');
  await expect(page.getByTestId('frozen-picture')).toBeVisible();
  const asked = page.waitForRequest('**/api/measure');
  const box = (await page.getByTestId('picture').boundingBox())!;
  await page.mouse.click(box.x + 0.4 * box.width, box.y + 0.7 * box.height);
  expect((await asked).postDataJSON()).toMatchObject({ frozen: 1 });
  await expect(page.getByTestId('measure')).toContainText(/mm ± /);

  await page.getByTestId('snapshot').click();
  await page.getByLabel('Note on this picture').fill('is this a crack?');
  await expectTouchable(page);
  await expectAccessible(page);
  await page.getByTestId('snapshot-save').click();
  await expect(page.getByTestId('snapshot-form')).toHaveCount(0);
  await page.getByTestId('snapshots').getByText('1 snapshot').click();
  await expect(page.getByTestId('snapshots')).toContainText('is this a crack? · Ann');
  // However many there are, the button for the next step stays where it is seen.
  for (let i = 0; i < 6; ++i)
    await page.evaluate(() => fetch('/api/inspections/1/snapshots', { method: 'POST', headers: { 'Content-Type': 'application/json' }, body: JSON.stringify({ stream: 'color', note: 'another', person: 'Ann' }) }));
  await page.reload();
  for (const viewport of [{ width: 1280, height: 800 }, { width: 820, height: 1180 }]) {
    await page.setViewportSize(viewport);
    if (viewport.width > viewport.height) await page.getByTestId('snapshots').getByText('7 snapshots').click();
    const list = (await page.getByTestId('snapshots').boundingBox())!;
    const end = viewport.width > viewport.height ? viewport.height : (await page.locator('footer').boundingBox())!.y;
    expect(list.y + list.height, 'not cut off').toBeLessThanOrEqual(end);
    await expect(page.getByTestId('capture-initial')).toBeInViewport({ ratio: 1 });
  }
  await page.getByTestId('freeze').click();
  await expect(page.getByTestId('frozen')).toBeVisible();
  await page.getByTestId('freeze').click();
  await expect(page.getByTestId('frozen')).toHaveCount(0);
});

test('a viewer points at something, and everybody sees it with the name', async ({ browser, served }) => {
  served.account('add', 'ann', ['--role', 'operator'], 'correct horse');
  served.account('add', 'expert', ['--role', 'viewer'], 'battery staple');
  const signedIn = async (name: string, password: string) => {
    const page = await (await browser.newContext()).newPage();
    await page.goto(served.address);
    await page.getByLabel('Name').fill(name);
    await page.getByLabel('Password').fill(password);
    await page.keyboard.press('Enter');
    await expect(page.getByTestId('live')).toBeVisible();
    return page;
  };
  const ann = await signedIn('ann', 'correct horse');
  const expert = await signedIn('expert', 'battery staple');
  await expect.poll(async () => Number(await expert.getByTestId('live').getAttribute('data-frame'))).toBeGreaterThan(0);
  await expect(expert.getByTestId('snapshot')).toHaveCount(0);
  await expert.getByTestId('point').click();
  await expectTouchable(expert);
  await expectAccessible(expert);
  const box = (await expert.getByTestId('picture').boundingBox())!;
  await expert.mouse.move(box.x + 0.3 * box.width, box.y + 0.4 * box.height);
  await expert.mouse.down();
  await expert.mouse.move(box.x + 0.5 * box.width, box.y + 0.6 * box.height, { steps: 3 });
  await expert.mouse.up();
  for (const page of [ann, expert]) await expect(page.getByTestId('pointed')).toContainText('expert');
  expect(await ann.getByTestId('pointed').locator('path').count()).toBeGreaterThan(0);
  // At the edges, the name stays within the picture.
  for (const [x, y] of [[0.01, 0.5], [0.99, 0.3], [0.5, 0.02]] as const) {
    await expert.mouse.click(box.x + x * box.width, box.y + y * box.height);
    await expert.waitForTimeout(400);
  }
  await expect(expert.getByTestId('pointed').locator('text')).toHaveCount(4);
  for (const name of await expert.getByTestId('pointed').locator('text').all()) {
    const text = (await name.boundingBox())!;
    expect(text.x).toBeGreaterThanOrEqual(box.x - 1);
    expect(text.x + text.width).toBeLessThanOrEqual(box.x + box.width + 1);
    expect(text.y).toBeGreaterThanOrEqual(box.y - 1);
  }
  // By keyboard, a circle in the middle.
  await expert.getByTestId('shape-circle').click();
  await expert.getByTestId('mark-middle').press('Enter');
  await expert.keyboard.press('Enter');
  await expect(ann.getByTestId('pointed').locator('ellipse').first()).toBeVisible();
  await expect(ann.getByTestId('pointed').locator('text')).toHaveCount(0, { timeout: 30_000 });
});
