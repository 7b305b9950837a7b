// Trends of the inspections in the list: charts by month, tables, and the file for spreadsheets.
import { readFileSync } from 'node:fs';
import type { Page } from '@playwright/test';
import type { Trend, Trends, VerdictCounts } from '../src/types';
import { expectAccessible, expectTouchable } from './accessibility';
import { begin, expect, test } from './served';

const none: VerdictCounts = { removed: 0, left: 0, unreachable: 0, installed: 0, false_alarms: 0, undecided: 0 };

function trend(inspections: number, found: Partial<VerdictCounts> = {}): Trend {
  const value = (found.false_alarms ?? 0) / inspections;
  const false_alarms_per_comparison = { value, low: value / 2, high: 2 * value + 0.1 };
  return { inspections, closed: inspections, median_hours: inspections / 2, comparisons: inspections, found: { ...none, ...found }, marked: none, false_alarms_per_comparison, debris: [{ name: '', objects: 3 }, { name: 'collar', objects: 7 }] };
}

const left = trend(4, { removed: 5, false_alarms: 1, installed: 20 });
const right = trend(2, { removed: 1, undecided: 1 });
const all: Trends = {
  sum: trend(6, { removed: 6, false_alarms: 1, installed: 20, undecided: 1 }),
  months: [
    { month: '2025-11', ...left },
    { month: '2026-02', ...right },
  ],
  zones: [
    { zone: 'left wing', ...left },
    { zone: 'right wing', ...right },
  ],
  zone_months: [
    { zone: 'left wing', month: '2025-11', ...left },
    { zone: 'right wing', month: '2026-02', ...right },
  ],
};

async function openTrends(page: Page): Promise<void> {
  await page.route(/\/api\/trends\?/, (route) => route.fulfill({ json: all }));
  await page.getByTestId('trends-open').click();
  await expect(page.getByTestId('trends-sum')).toContainText('6 inspections, 6 closed, 6 comparisons.');
}

test('months without an inspection are gaps, and parts of a column are as high as what they count', async ({ console: page }) => {
  await openTrends(page);
  const chart = page.getByRole('img', { name: 'Findings by decision' });
  await expect(chart.locator('text', { hasText: /Nov|Dec|Jan|Feb/ })).toHaveCount(4);
  const height = async (title: string) => Number(await chart.locator('rect', { has: page.locator('title', { hasText: title }) }).getAttribute('height'));
  expect((await height('Nov 2025: Installed work 20')) / (await height('Nov 2025: Debris, removed 5'))).toBeCloseTo(4, 5);
  expect(await height('Feb 2026: Debris, removed 1')).toBeCloseTo(await height('Feb 2026: Undecided 1'), 5);
  await expect(page.getByRole('img', { name: 'False alarms per comparison' }).locator('.chart-interval')).toHaveCount(2);
  await expect(page.locator('.debris-names li').first()).toHaveText('collar 7');
  await expectAccessible(page);
  await expectTouchable(page);
});

test('of one zone alone', async ({ console: page }) => {
  await openTrends(page);
  await page.getByRole('button', { name: 'right wing' }).click();
  await expect(page.getByTestId('trends-zone')).toHaveValue('right wing');
  await expect(page.getByTestId('trends-sum')).toContainText('2 inspections');
  await expect(page.getByRole('table', { name: 'By month' }).getByRole('row')).toHaveCount(2);
  await page.getByTestId('trends-zone').selectOption('All (2)');
  await expect(page.getByTestId('trends-sum')).toContainText('6 inspections');
});

test('the server adds up what the list shows, also as CSV, and the address leads back', async ({ console: page }) => {
  await begin(page);
  await page.getByTestId('home').click();
  await page.getByTestId('trends-open').click();
  const sum = page.getByTestId('trends-sum');
  await expect(sum).toHaveText('1 inspection, 0 closed, 0 comparisons.');
  const saved = page.waitForEvent('download');
  await page.getByTestId('trends-csv').click();
  const lines = readFileSync(await (await saved).path(), 'utf8').split('\r\n');
  expect(lines[0]).toContain('zone,month,inspections');
  expect(lines[1]).toContain('"Left wing, bay 3"');
  await page.reload();
  await expect(sum, 'after a reload').toBeVisible();
  await page.getByTestId('search').fill('nowhere');
  await expect(page.getByTestId('trends')).toContainText('No inspection matches.');
  await page.getByTestId('search').fill('wing');
  await expect(page.getByTestId('trends')).toContainText('Only the inspections that match the search.');
  await page.getByTestId('open-1').click();
  await expect(page.getByTestId('trends')).toHaveCount(0);
  await page.goBack();
  await expect(sum).toBeVisible();
  await page.getByTestId('trends-close').click();
  await expect(page.getByTestId('trends')).toHaveCount(0);
});
