// A finding that the program missed is marked in a picture: by touch, mouse and keyboard.
import { expect, test, type Page } from '@playwright/test';
import { expectAccessible, expectTouchable } from './accessibility';
import { mount } from './mounted';

const source = `
import '/src/base.css';
import '/src/picture.css';
import '/src/switch.css';
import { render } from 'preact';
import { MarkBar, MarkButton, useMarking } from '/src/picture/marking';
import { whole } from '/src/picture/zoom';
import { ZoomButtons } from '/src/picture/ZoomButtons';
import { ZoomPicture } from '/src/picture/ZoomPicture';
import { Store } from '/src/store';

const size = { width: 800, height: 400 };
const zoom = new Store(whole);
window.marked = [];
function Pictures() {
  const marking = useMarking((box) => window.marked.push(box));
  return (
    <section class="view">
      {marking.active ? <MarkBar marking={marking} size={size} zoom={zoom} /> : <div class="view-bar"><MarkButton marking={marking} shown={true} /><ZoomButtons zoom={zoom} /></div>}
      <ZoomPicture size={size} zoom={zoom} label="Picture" marking={marking}>
        <canvas width="800" height="400" />
      </ZoomPicture>
    </section>
  );
}
render(<Pictures />, document.getElementById('here'));
`;

const marked = (page: Page) => page.evaluate(() => (window as unknown as { marked: number[][] }).marked);

async function at(page: Page, u: number, v: number): Promise<[number, number]> {
  const box = (await page.locator('canvas').boundingBox())!;
  return [box.x + (u / 800) * box.width, box.y + (v / 400) * box.height];
}

// The mouse is in whole pixels of the screen.
function expectNear(box: number[], wanted: number[]): void {
  for (const [i, value] of wanted.entries()) expect(Math.abs(box[i]! - value), String(box)).toBeLessThanOrEqual(1);
}

test.beforeEach(async ({ page }) => mount(page, source));

test('a tap marks a box of the usual size, a drag one of its own, and each ends marking', async ({ page }) => {
  await page.mouse.click(...(await at(page, 100, 100)));
  expect(await marked(page), 'nothing without the button').toEqual([]);
  await page.getByTestId('mark').click();
  await expectTouchable(page);
  await expectAccessible(page);
  await page.mouse.click(...(await at(page, 400.5, 200.5)));
  await expect.poll(async () => (await marked(page)).length).toBe(1);
  expectNear((await marked(page))[0]!, [388, 188, 24, 24]);
  await expect(page.getByTestId('mark-bar')).toHaveCount(0);

  await page.getByTestId('zoom-in').click();
  await page.getByTestId('mark').click();
  await page.mouse.move(...(await at(page, 350.5, 150.5)));
  await page.mouse.down();
  await page.mouse.move(...(await at(page, 380, 170)));
  await page.mouse.move(...(await at(page, 449.5, 229.5)));
  await expect(page.getByTestId('mark-box')).toBeVisible();
  await page.mouse.up();
  await expect.poll(async () => (await marked(page)).length).toBe(2);
  expectNear((await marked(page))[1]!, [350, 150, 100, 80]);
  expect(await page.getByTestId('picture').getAttribute('data-scale'), 'a drag draws, it does not move the picture').toBe('1.50');
});

test('by keyboard: a box in the middle is moved, resized and confirmed, or left', async ({ page }) => {
  await page.getByTestId('mark').press('Enter');
  await page.getByTestId('mark-middle').press('Enter');
  const box = page.getByTestId('mark-box');
  await expect(box).toBeFocused();
  const boxNow = async () => (await box.getAttribute('data-box'))!.split(' ').map(Number);
  const [u, v, width, height] = (await boxNow()) as [number, number, number, number];
  expect(Math.abs(u + width / 2 - 400)).toBeLessThanOrEqual(1);
  await page.keyboard.press('ArrowLeft');
  await expect.poll(async () => (await boxNow())[0]).toBeLessThan(u);
  await page.keyboard.press('Shift+ArrowDown');
  await expect.poll(async () => (await boxNow())[3]).toBeGreaterThan(height);
  expect((await boxNow())[1]).toBe(v);
  const last = await boxNow();
  await expectAccessible(page);
  await page.keyboard.press('Enter');
  await expect.poll(() => marked(page)).toEqual([last]);

  await page.getByTestId('mark').press('Enter');
  await page.getByTestId('mark-middle').press('Enter');
  await expect(box).toBeFocused();
  await page.keyboard.press('Escape');
  await expect(page.getByTestId('mark')).toBeVisible();
  expect(await marked(page)).toHaveLength(1);
});
