// Close-ups: both crops show the same part, with nothing over it, not enlarged beyond sense; a tap makes them wide.
import { expect, test } from '@playwright/test';
import { expectAccessible, expectTouchable } from './accessibility';
import { mount } from './mounted';

const source = `
import '/src/base.css';
import { render } from 'preact';
import { CloseUp } from '/src/picture/CloseUp';

const picture = (color) => 'data:image/svg+xml,' + encodeURIComponent('<svg xmlns="http://www.w3.org/2000/svg" width="848" height="480"><rect width="848" height="480" fill="#888"/><rect x="400" y="200" width="8" height="6" fill="' + color + '"/></svg>');
render(<div style="width: 600px"><CloseUp before={picture('#888')} after={picture('red')} size={{ width: 848, height: 480 }} bbox={[400, 200, 8, 6]} /></div>, document.getElementById('here'));
`;

test('before and after are shown side by side, and wide after a tap', async ({ page }) => {
  await mount(page, source);
  const crops = page.getByTestId('close-up').locator('svg');
  await expect(crops).toHaveCount(2);
  expect(await crops.nth(0).getAttribute('viewBox')).toBe(await crops.nth(1).getAttribute('viewBox'));
  for (const crop of await crops.all()) await expect(crop.locator('> *')).toHaveCount(1);
  const times = async () => crops.nth(0).evaluate((svg: SVGSVGElement) => svg.getBoundingClientRect().width / svg.viewBox.baseVal.width);
  const narrow = (await crops.nth(0).boundingBox())!;
  expect((await crops.nth(1).boundingBox())!.x).toBeGreaterThan(narrow.x + narrow.width);
  expect(await times()).toBeLessThanOrEqual(4);
  await expectTouchable(page);
  await expectAccessible(page);
  await page.getByRole('button', { name: 'After' }).click();
  await expect.poll(async () => (await crops.nth(1).boundingBox())!.width).toBeGreaterThan(1.8 * narrow.width);
  expect(await times()).toBeLessThanOrEqual(4);
  await page.getByRole('button', { name: 'After' }).click();
  await expect.poll(async () => (await crops.nth(1).boundingBox())!.width).toBeCloseTo(narrow.width, 0);
});
