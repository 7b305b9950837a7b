// The layer that shows where an object of one size would have been found.
import { expectAccessible, expectTouchable } from './accessibility';
import { openReview } from './review_page';
import { expect, test } from './served';

test('where an object would have been found is shown for one size at a time, of the view that is shown', async ({ console: page }) => {
  await openReview(page);
  const picture = page.getByTestId('picture-findable');
  await expect(picture, 'nothing unless asked for').toHaveCount(0);
  await page.getByTestId('show-menu').click();
  await page.getByTestId('findable-10').click();
  await expect(page.getByTestId('findable-legend')).toHaveText(/object of 10 mm would have been found: 70 % of this view/);
  await expect(picture).toHaveAttribute('src', /views\/0\/findable_10mm\.png$/);
  expect(await picture.boundingBox(), 'pixel upon pixel').toEqual(await page.getByTestId('picture-after').boundingBox());
  await page.getByTestId('findable-5').click();
  await expect(page.getByTestId('findable-legend')).toHaveText(/object of 5 mm would have been found: 40 % of this view/);
  await page.getByTestId('review-view-1').click();
  await expect(picture).toHaveAttribute('src', /views\/1\/findable_5mm\.png$/);
  await expectTouchable(page);
  await expectAccessible(page);
  await page.getByTestId('findable-0').click();
  await expect(picture).toHaveCount(0);
  await expect(page.getByTestId('findable-legend')).toHaveCount(0);
});

test('that a comparison has no such pictures is stated', async ({ console: page }) => {
  await openReview(page);
  await page.route(/findable_5mm\.png/, (route) => route.fulfill({ status: 404, json: {} }));
  await page.getByTestId('show-menu').click();
  await page.getByTestId('findable-5').click();
  await expect(page.getByTestId('findable-legend')).toContainText('earlier version');
  await expect(page.getByTestId('picture-findable')).toHaveCount(0);
  await page.getByTestId('findable-10').click();
  await expect(page.getByTestId('findable-legend'), 'of the other size there is one').toContainText('10 mm');
});
