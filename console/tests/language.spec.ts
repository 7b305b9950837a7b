// The console in another language.
import { expectAccessible, expectTouchable } from './accessibility';
import { openReview } from './review_page';
import { expect, test } from './served';

test('a language is chosen before the sign-in, is kept, and so are the reasons why a sign-in fails', async ({ console: page, served }) => {
  served.account('add', 'vera', ['--role', 'viewer'], 'correct horse');
  await page.reload();
  const html = page.locator('html');
  const alert = page.getByRole('alert');
  await expect(page.getByTestId('language-en')).toBeChecked();
  await page.getByTestId('language-de').click();
  await expect(html).toHaveAttribute('lang', 'de');
  await expect(page.getByTestId('language-de')).toBeChecked();
  await page.getByLabel('Name').fill('vera');
  await page.getByLabel('Passwort').fill('wrong horse');
  await page.getByRole('button', { name: 'Anmelden' }).click();
  await expect(alert).toHaveText('Name oder Passwort ist falsch. Versuchen Sie es noch einmal.');
  await expectTouchable(page);
  await expectAccessible(page);
  await page.getByTestId('language-en').click();
  await expect(alert).toHaveText('The name or password is wrong. Try again.');
  await expect(html).toHaveAttribute('lang', 'en');
  await page.getByTestId('language-de').click();

  await page.reload();
  await expect(html).toHaveAttribute('lang', 'de');
  await page.getByLabel('Name').fill('vera');
  await page.getByLabel('Passwort').fill('correct horse');
  await page.getByTestId('sign-in').click();
  await expect(page.getByLabel('Flugzeug')).toBeVisible();
  await page.getByRole('button', { name: 'vera · abmelden' }).click();
  await expect(page.getByTestId('language-de')).toBeChecked();
});

test('what the server refuses is stated in German, with its English sentence marked as such', async ({ console: page }) => {
  await page.getByTestId('language').click();
  await page.route('**/api/inspections', (route) => (route.request().method() === 'POST' ? route.fulfill({ status: 409, json: { error: { code: 'somebody-drives', message: 'robot: Bob is driving' } } }) : route.fallback()));
  await page.getByLabel('Flugzeug').fill('OE-ABC');
  await page.getByLabel('Zone').fill('Tragfläche links');
  await page.getByLabel('Ihr Name').fill('Ann');
  await page.getByTestId('begin').click();
  await expect(page.getByTestId('trouble')).toContainText('Jemand anderes steuert gerade.');
  await expect(page.getByTestId('trouble').locator('[lang=en]')).toHaveText('robot: Bob is driving');
  await expectAccessible(page);
  await page.getByTestId('language').click();
  await expect(page.getByTestId('trouble')).toContainText('Somebody else is driving.');
});

test('the check before a capture is stated in German', async ({ console: page }) => {
  await page.getByTestId('language').click();
  await page.getByLabel('Flugzeug').fill('OE-ABC');
  await page.getByLabel('Zone').fill('Tragfläche links');
  await page.getByLabel('Ihr Name').fill('Ann');
  await page.getByTestId('begin').click();
  const readiness = page.getByTestId('readiness');
  await expect(readiness).toContainText('Kamera: bereit');
  await expect(readiness).toContainText(/\d,\d Bilder pro Sekunde/);
  await expect(readiness).toContainText(/Schwenkwinkel -?\d+,\d°/);
  await expect(readiness).toContainText(/\d,\d GB frei/);
  await expect(readiness.locator('[lang=en]')).toHaveCount(0);
});

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
