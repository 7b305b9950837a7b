// What the terms mean, behind a question mark.
import { expectAccessible, expectTouchable } from './accessibility';
import { openReview } from './review_page';
import { expect, test } from './served';

test('terms are explained, those of the page first, and keys scroll them alone', async ({ console: page }) => {
  await openReview(page);
  await page.getByTestId('reveal').click();
  await page.getByTestId('glossary-open').click();
  const glossary = page.getByTestId('glossary');
  await expect(glossary).toBeVisible();
  await expect(glossary.getByRole('term').first()).toHaveText('Finding');
  await expect(glossary.getByTestId('term-level')).toContainText('nine of ten inspections');
  await expect(glossary.getByTestId('term-deadZone'), 'of another page').toBeAttached();
  await expectTouchable(page);
  await expectAccessible(page);
  let decided = false;
  await page.route('**/decisions', (route) => {
    decided = true;
    return route.abort();
  });
  await page.keyboard.press('5');
  await page.keyboard.press('Escape');
  await expect(glossary).toBeHidden();
  expect(decided).toBe(false);
  await expect(page.getByTestId('glossary-open')).toBeFocused();
});

test('terms are explained in German', async ({ console: page }) => {
  await page.setViewportSize({ width: 820, height: 1180 });
  await page.getByTestId('language').click();
  await page.getByTestId('glossary-open').click();
  await expect(page.getByTestId('term-baseline')).toContainText('Basisaufnahme');
  await expectTouchable(page);
  await expectAccessible(page);
  await page.getByTestId('glossary-close').click();
  await expect(page.getByTestId('glossary')).toBeHidden();
  const beyond = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
  expect(beyond).toBe(0);
});
