// Months and scales of the charts.
import { expect, test } from '@playwright/test';
import { monthsOf, roundedUp } from '../../src/trends/months';
import type { Trend, Trends } from '../../src/types';

const none = { removed: 0, left: 0, unreachable: 0, installed: 0, false_alarms: 0, undecided: 0 };
const trend: Trend = { inspections: 1, closed: 0, comparisons: 0, found: none, marked: none, debris: [] };

function trendsIn(...months: string[]): Trends {
  return { sum: trend, months: months.map((month) => ({ month, ...trend })), zones: [], zone_months: [{ zone: 'a', month: months[0] ?? '', ...trend }] };
}

test('every month between the first and the last is there', () => {
  const months = monthsOf(trendsIn('2025-11', '2026-02'), null, 36);
  expect(months.map(({ month }) => month)).toEqual(['2025-11', '2025-12', '2026-01', '2026-02']);
  expect(months.map((one) => one.trend !== null)).toEqual([true, false, false, true]);
  expect(monthsOf(trendsIn('2025-11', '2026-02'), 'a', 36).map(({ month }) => month)).toEqual(['2025-11']);
});

test('of many months the last ones are there', () => {
  const months = monthsOf(trendsIn('0001-01', '2026-02'), null, 3);
  expect(months.map(({ month }) => month)).toEqual(['2025-12', '2026-01', '2026-02']);
});

test('nothing, and what is no month, is no month', () => {
  expect(monthsOf(trendsIn(), null, 36)).toEqual([]);
  expect(monthsOf(trendsIn('soon', '2026-02'), null, 36)).toEqual([]);
});

test('scales end at round numbers', () => {
  expect([0.1, 0.11, 1, 1.5, 2, 2.1, 5.1, 10, 11, 999].map(roundedUp)).toEqual([0.1, 0.2, 1, 2, 2, 5, 10, 10, 20, 1000]);
});
