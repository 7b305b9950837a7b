// The exposure of the infrared imagers, set in the live picture.
import { expectAccessible, expectTouchable } from './accessibility';
import { begin, expect, openAsViewer, test } from './served';

test('a person fixes the exposure and hands it back to the camera', async ({ console: page }) => {
  await begin(page);
  await expect(page.getByTestId('exposure'), 'colour has an imager of its own').toHaveCount(0);
  await page.getByTestId('stream-infrared').click();
  await page.getByTestId('exposure').click();
  const bar = page.getByTestId('exposure-bar');
  await expect(page.getByTestId('exposure-automatic')).toBeChecked();
  await expect(page.getByTestId('exposure-time')).toBeDisabled();
  await expectTouchable(page);
  await expectAccessible(page);

  const brightness = () =>
    page.getByTestId('live').evaluate((canvas: HTMLCanvasElement) => {
      const { data } = canvas.getContext('2d')!.getImageData(0, 0, canvas.width, canvas.height);
      return data.reduce((sum, value, i) => (i % 4 === 0 ? sum + value : sum), 0) / (data.length / 4);
    });
  await expect(page.getByTestId('live')).toHaveAttribute('data-stream', 'infrared');
  await expect.poll(brightness).toBeGreaterThan(5);
  const before = await brightness();
  await page.getByTestId('exposure-fixed').click();
  const time = page.getByTestId('exposure-time');
  await expect(time).toBeEnabled();
  await time.fill('0.2');
  await expect.poll(brightness, 'shorter is darker').toBeLessThan(0.5 * before);
  await page.getByTestId('exposure-automatic').click();
  await expect.poll(brightness).toBeGreaterThan(0.9 * before);
  await page.keyboard.press('Escape');
  await expect(bar).toHaveCount(0);
});

test('a viewer sees no control of the exposure', async ({ browser, served }) => {
  const page = await openAsViewer(browser, served);
  await page.getByTestId('stream-infrared').click();
  await expect(page.getByTestId('freeze')).toBeVisible();
  await expect(page.getByTestId('exposure')).toHaveCount(0);
});
