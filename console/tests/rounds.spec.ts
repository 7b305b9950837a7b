// Earlier rounds: their pictures, findings and maps as they were, each with an address.
import type { Page } from '@playwright/test';
import type { Inspection, Round } from '../src/types';
import { expectAccessible, expectTouchable } from './accessibility';
import { inspectionOf, openAt } from './region_page';
import { openReview, wall } from './review_page';
import { expect, test } from './served';

/** A review whose valid comparison is the third one, after two of which the first found an object and has a map. */
async function openRounds(page: Page): Promise<void> {
  await openReview(page);
  const reviewed = await inspectionOf(page);
  const inspection: Inspection = { ...reviewed, comparison: 3 };
  const at = (day: number) => `2025-01-0${day}T12:00:00Z`;
  const round = (comparison: number, findings: Round['findings']): Round => ({ comparison, compared_at: at(comparison), compared: reviewed.compared, findings });
  const found = { ...reviewed.findings[2]!, number: 1, same_as: 1, in_foot_m: [0.05, 0.6, 0.02] as Round['findings'][0]['in_foot_m'] };
  await page.route('**/api/inspections/1', (route) => route.fulfill({ json: inspection }));
  await page.route('**/api/inspections/1/rounds', (route) => route.fulfill({ json: { rounds: [round(3, reviewed.findings), round(2, []), round(1, [found])] } }));
  for (const comparison of [1, 3]) {
    await page.route(`**/api/inspections/1/rounds/${comparison}/map`, (route) => route.fulfill({ body: wall() }));
    if (comparison === 3) await page.route('**/api/inspections/1/rounds/3/changes', (route) => route.fulfill({ body: wall() }));
  }
  await page.reload();
  await page.getByTestId('reveal').click();
}

test('the map of an earlier round is shown, which has an address, and it is stated where there is none', async ({ console: page }) => {
  await openRounds(page);
  await page.getByTestId('page-space').click();
  await expect(page.getByTestId('map-status')).toContainText('Drag to turn');
  const asked = page.waitForRequest('**/rounds/1/map');
  await page.getByTestId('round-1').click();
  await asked;
  await expect(page.getByTestId('earlier-round')).toContainText('Round 1, as it was.');
  await expect(page.getByTestId('map-status')).toContainText('Drag to turn');
  await expect(page.getByTestId('finding-summary')).toContainText('1 finding');
  await expect(page).toHaveURL(/#\/inspections\/1\/rounds\/1\/space$/);
  // Its changes were not kept.
  await page.getByTestId('coloring-change').click();
  await expect(page.getByTestId('map-status')).toContainText('not kept for this round');
  await expectTouchable(page);
  await expectAccessible(page);

  await page.getByTestId('round-2').click();
  await expect(page.getByTestId('map-missing')).toContainText('no map of this round');
  await expect(page.getByTestId('measure-begin')).toHaveCount(0);
  await expectTouchable(page);
  await expectAccessible(page);

  await page.goBack();
  await expect(page.getByTestId('earlier-round')).toContainText('Round 1, as it was.');
  await expect(page.getByTestId('map-missing')).toHaveCount(0);
  await page.reload();
  await expect(page.getByTestId('earlier-round')).toContainText('Round 1, as it was.');
  await expect(page.getByTestId('map-status')).toContainText('Drag to turn');
  await page.getByTestId('page-review').click();
  await expect(page).toHaveURL(/#\/inspections\/1\/rounds\/1\/review$/);
  await page.goBack();
  await expect(page.getByTestId('space')).toBeVisible();
  await page.getByRole('button', { name: 'Back to the current round' }).click();
  await expect(page).toHaveURL(/#\/inspections\/1\/space$/);
  await page.goBack();
  await expect(page.getByTestId('earlier-round')).toBeVisible();
});

test('an address leads to a finding of an earlier round, and one of a round that does not exist to the current one', async ({ console: page }) => {
  await openRounds(page);
  for (const [hash, shown] of [['rounds/1/review/1', 'rounds/1/review/1'], ['rounds/7/review', 'review'], ['rounds/3/review/3', 'review/3']] as const) {
    await openAt(page, `#/inspections/1/${hash}`);
    await expect(page.getByTestId('moment-before')).toBeVisible();
    await expect(page).toHaveURL(new RegExp(`#/inspections/1/${shown}$`));
    await expect(page.getByTestId('earlier-round')).toHaveCount(shown.startsWith('rounds') ? 1 : 0);
  }
  await expect(page.getByTestId('finding-3')).toHaveClass(/selected/);
});

test('what is measured in the map of an earlier round is asked of that round', async ({ console: page }) => {
  await openRounds(page);
  await page.getByTestId('page-space').click();
  await page.getByTestId('round-1').click();
  await expect(page.getByTestId('map-status')).toContainText('Drag to turn');
  const asked = page.waitForRequest('**/rounds/1/map/measure');
  await page.route('**/map/measure', (route) => route.fulfill({ status: 404, json: { error: { code: 'not-found', message: 'captures: are gone' } } }));
  await page.getByTestId('measure-begin').click();
  await page.getByTestId('measure-middle').click();
  await page.getByTestId('measure-middle').click();
  expect((await asked).method()).toBe('POST');
  await expect(page.getByTestId('measure-result')).toContainText('captures: are gone');
});
