// The lamp around the camera, switched beside the stick.
import { expectAccessible, expectTouchable } from './accessibility';
import { begin, expect, openAsViewer, test } from './served';

test('a person lights the bay, and sees it brighter', async ({ console: page }) => {
  await begin(page);
  await page.getByTestId('stream-color').click();
  await expect(page.getByTestId('live')).toHaveAttribute('data-stream', 'color');
  const brightness = () =>
    page.getByTestId('live').evaluate((canvas: HTMLCanvasElement) => {
      const { data } = canvas.getContext('2d')!.getImageData(0, 0, canvas.width, canvas.height);
      return data.reduce((sum, value, i) => (i % 4 === 1 ? sum + value : sum), 0) / (data.length / 4);
    });
  await page.getByTestId('lamp').click();
  await expect(page.getByTestId('lamp-0')).toBeChecked();
  await expect.poll(brightness).toBeGreaterThan(1);
  const before = await brightness();
  await expectTouchable(page);
  await expectAccessible(page);
  await page.getByTestId('lamp-100').click();
  await expect(page.getByTestId('lamp-100')).toBeChecked();
  await expect.poll(brightness).toBeGreaterThan(1.2 * before);
  await page.getByTestId('lamp-0').click();
  await expect(page.getByTestId('lamp-0')).toBeChecked();
  await expect.poll(brightness).toBeLessThan(1.1 * before);
  await page.getByTestId('lamp-close').click();
  await expect(page.getByTestId('lamp-0')).toHaveCount(0);
});

test('a viewer sees no switch of the lamp', async ({ browser, served }) => {
  const page = await openAsViewer(browser, served);
  await expect(page.getByTestId('freeze')).toBeVisible();
  await expect(page.getByTestId('lamp')).toHaveCount(0);
});
