// Phrases about inspections and findings.
import { expect, test } from '@playwright/test';
import { findableText, leastFindable, millimetres, signOf, suspicion, titleOf, whatChanged, whereAndHow } from '../../src/inspection/words';
import type { ComparedView } from '../../src/types';
import type { InspectionSummary } from '../../src/types';
import { finding } from './findings';

const summary: InspectionSummary = {
  id: 7, aircraft: 'N123AB', zone: 'Left wing, bay 3', work_order: '', person: 'Ann', created_at: '2025-01-01T12:00:00Z',
  stage: 'baseline', findings_count: 0, undecided_count: 0,
};

test('a title has what was stated, or the number', () => {
  expect(titleOf(summary)).toBe('N123AB · Left wing, bay 3');
  expect(titleOf({ ...summary, work_order: 'WO-4711' })).toBe('N123AB · Left wing, bay 3 · WO-4711');
  expect(titleOf({ ...summary, aircraft: '', zone: '' })).toBe('Inspection 7');
});

test('lengths below 10 mm have a decimal place', () => {
  expect([0.04, 3.14, 10, 123.6].map(millimetres)).toEqual(['0.0 mm', '3.1 mm', '10 mm', '124 mm']);
});

test('suspicion follows the p-value', () => {
  const level = (p_value: number) => suspicion(finding(1, { p_value })).level;
  expect([0, 9e-7, 1e-6, 9e-4, 1e-3, 1].map(level)).toEqual([3, 3, 2, 2, 1, 1]);
  expect(suspicion(finding(1)), 'of a method without p-values').toEqual({ level: 2, name: 'Changed' });
});

test('every kind has a phrase and a sign', () => {
  for (const kind of ['added', 'removed', 'appearance'] as const) {
    expect(whatChanged(finding(1, { kind }))).not.toBe('');
    expect(signOf({ kind })).toHaveLength(1);
  }
});

test('a finding is described by what is known about it', () => {
  expect(whereAndHow(finding(1))).toBe('');
  expect(whereAndHow(finding(1, { class: 'drill bit', probability: 0.874 }))).toBe('may be: drill bit (87 %)');
  expect(whereAndHow(finding(1, { class: 'of a later version', probability: 0.9 }))).toBe('may be: of a later version (90 %)');
  expect(whereAndHow(finding(1, { class: 'unknown', probability: 0.3 })), 'an unknown class is no hint').toBe('');
  expect(whereAndHow(finding(1, { size_mm: [12.4, 8.25], position_m: [0, 0, 0.456], height_mm: -3.2 }))).toBe(
    '12 mm × 8.3 mm, 0.46 m away, surface 3.2 mm nearer than before',
  );
  expect(whereAndHow(finding(1, { kind: 'removed', height_mm: 14 }))).toBe('surface 14 mm farther than before');
  expect(whereAndHow(finding(1, { kind: 'appearance' }))).toBe('brighter or darker than before; not visible in depth');
  expect(whereAndHow(finding(1, { kind: 'appearance', evidence: [] }), true), 'nothing is known of a change').toBe('');
});

test('height is that above the surroundings where it is known, and a jump of the background is stated', () => {
  expect(whereAndHow(finding(1, { height_mm: 31, above_surroundings_mm: 30, background_jump: false }))).toBe('30 mm above its surroundings');
  expect(whereAndHow(finding(1, { height_mm: 157, above_surroundings_mm: 30, background_jump: true }))).toBe(
    '30 mm above its surroundings, at an edge, where the background jumps',
  );
  expect(whereAndHow(finding(1, { kind: 'removed', above_surroundings_mm: 7, background_jump: false }))).toBe('7.0 mm above its surroundings before');
});

test('how high an object is at its top is stated where that is known, at least where it may be higher', () => {
  const heights = { height_mm: 157, above_surroundings_mm: 6, top_above_surroundings_mm: 12 };
  expect(whereAndHow(finding(1, { ...heights, background_jump: false, top_is_least: false }))).toBe('12 mm high');
  expect(whereAndHow(finding(1, { ...heights, background_jump: true, top_is_least: true }))).toBe('at least 12 mm high, at an edge, where the background jumps');
  expect(whereAndHow(finding(1, { ...heights, kind: 'removed', top_is_least: true }))).toBe('at least 12 mm high before');
});

test('a share is named with the size that it is of, and is that of the least favourable view', () => {
  const views = [
    { findable: [{ size_mm: 5, share: 0.4 }, { size_mm: 10, share: 0.8 }] },
    { findable: [{ size_mm: 5, share: 0.5 }, { size_mm: 10, share: 0.7 }] },
  ] as ComparedView[];
  expect(findableText(leastFindable(views))).toBe('objects of 5 mm would have been found in 40 % of it, of 10 mm in 70 %');
  expect(findableText(leastFindable(views), 'expected')).toBe('objects of 5 mm are expected to be found in 40 % of the view, of 10 mm in 70 %');
  expect(findableText(leastFindable([...views, { findable: [] } as unknown as ComparedView])), 'not known of one view').toBe('objects of 5 mm would have been found in 0 % of it, of 10 mm in 0 %');
  expect(findableText(leastFindable([]))).toBe('');
});
