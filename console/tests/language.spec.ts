// The console in another language.
import { expectAccessible, expectTouchable } from './accessibility';
import { openReview } from './review_page';
import { expect, test } from './served';

test('the console is switched to German, which is kept, and a review is done in it', async ({ console: page }) => {
  await openReview(page);
  await expect(page.locator('html')).toHaveAttribute('lang', 'en');
  await page.getByTestId('language').click();
  await expect(page.locator('html')).toHaveAttribute('lang', 'de');
  await expect(page.getByTestId('first-look')).toContainText('Erster Blick');
  await page.reload();
  await expect(page.locator('html')).toHaveAttribute('lang', 'de');
  await page.getByTestId('reveal').click();
  await expect(page.getByTestId('finding-summary')).toContainText('2 Befunde');
  await expect(page.getByTestId('finding-1')).toContainText('Zu entscheiden');
  await expect(page.getByTestId('verdict-false-alarm')).toContainText('Fehlalarm');
  await expectTouchable(page);
  await expectAccessible(page);
  await page.getByTestId('page-live').click();
  await expect(page.getByTestId('angle-tilt')).toContainText('Neigen');
  await expect(page.getByTestId('angle-tilt')).toContainText(/-20,\d°/);
  await page.getByTestId('home').click();
  await expect(page.getByLabel('Flugzeug')).toBeVisible();
  await page.getByTestId('language').click();
  await expect(page.getByLabel('Aircraft')).toBeVisible();
});

test.describe('in a German browser', () => {
  test.use({ locale: 'de-AT' });

  for (const viewport of [{ width: 1280, height: 800 }, { width: 820, height: 1180 }])
    test(`the console is German from the beginning, and fits ${viewport.width} pixels`, async ({ console: page }) => {
      await page.setViewportSize(viewport);
      await page.getByLabel('Flugzeug').fill('OE-ABC');
      await page.getByLabel('Zone').fill('Tragfläche links');
      await page.getByLabel('Ihr Name').fill('Ann');
      await page.getByTestId('begin').click();
      await expect(page.getByTestId('capture-initial')).toHaveText('Basisaufnahme machen');
      await expect(page.getByTestId('readiness')).toContainText('Bereit?');
      const beyond = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
      expect(beyond).toBe(0);
      await expectTouchable(page);
      await expectAccessible(page);
      expect(await page.evaluate(() => performance.getEntriesByType('resource').filter(({ name }) => /\/de-.*\.js/.test(name)).length), 'loaded for this language alone').toBe(1);
    });
});
