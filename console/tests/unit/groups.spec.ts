// Findings of one object in several views, joined, and objects that were moved.
import { expect, test } from '@playwright/test';
import { bestSeen, decisionOf, groupsOf, isSettled, nextUndecided } from '../../src/review/groups';
import { movedFrom, movedTo } from '../../src/review/moves';
import { swipeOf } from '../../src/review/swipe';
import type { Decision, Inspection, MarkedFinding, Verdict } from '../../src/types';
import { finding } from './findings';

function groups(...findings: Inspection['findings']) {
  return groupsOf({ findings, marked: [] as MarkedFinding[] } as Inspection);
}

test('there are no groups without findings', () => {
  expect(groups()).toEqual([]);
});

test('findings of one object are one group, whose first finding leads', () => {
  const [first, second] = groups(finding(1), finding(2), finding(3, { same_as: 1, view: 1 }));
  expect([first!.label, second!.label], 'numbered from 1 without gaps').toEqual([1, 2]);
  expect(first!.lead.number).toBe(1);
  expect(first!.all.map(({ number }) => number)).toEqual([1, 3]);
  expect(second!.all.map(({ number }) => number)).toEqual([2]);
});

test('an object is seen best where most of it is clear, and where that is not known in the most suspicious view', () => {
  const best = (...clear_px: (number | undefined)[]) => {
    const [group] = groups(...clear_px.map((px, view) => finding(view + 1, { same_as: 1, view, ...(px !== undefined && { clear_px: px }) })));
    return bestSeen(group!).view;
  };
  expect(best(40, 90, 60)).toBe(1);
  expect(best(90, 90), 'as clear').toBe(0);
  expect(best(0, 0), 'at the border in each').toBe(0);
  expect(best(undefined, undefined), 'of an earlier version').toBe(0);
});

test('the decision on a group is that on the finding that leads it', () => {
  const decision: Decision = { verdict: 'false-alarm', note: '', person: 'Ann', decided_at: '2025-01-01T12:00:00Z', round: 1 };
  const [decided, open] = groups(finding(1, { decision }), finding(2), finding(3, { same_as: 2, decision }));
  expect(decisionOf(decided!)).toBe(decision);
  expect(decisionOf(open!)).toBeUndefined();
});

test('an object that was moved is followed by the numbers of the list, through what is joined', () => {
  const all = groups(
    finding(1),
    finding(2, { same_as: 1, view: 1, moved_from: 4 }),
    finding(3, { kind: 'removed' }),
    finding(4, { same_as: 3, kind: 'removed', view: 1 }),
    finding(5),
  );
  const [added, removed, other] = [all[0]!, all[1]!, all[2]!];
  expect(movedFrom(all, added)?.label).toBe(2);
  expect(movedTo(all, removed).map(({ label }) => label)).toEqual([1]);
  for (const group of [removed, other]) expect(movedFrom(all, group)).toBeUndefined();
  for (const group of [added, other]) expect(movedTo(all, group)).toEqual([]);
});

const marked: MarkedFinding = { number: 2, round: 1, view: 1, comparison: 3, bbox: [4, 6, 3, 5], note: 'a rag', person: 'Ann', marked_at: '2025-01-01T12:00:00Z' };

test('what a person marked follows the findings, under a number that no finding has', () => {
  const [first, second] = groupsOf({ findings: [finding(2)], marked: [marked] } as unknown as Inspection);
  expect(first!.marked).toBeUndefined();
  expect(second!.marked).toBe(marked);
  expect(second!.label).toBe(2);
  expect(second!.lead.number).toBe(-2);
  expect(second!.lead.centroid).toEqual([5, 8]);
  expect(second!.lead.view).toBe(1);
});

test('a mark in the live picture is in none of the views', () => {
  const { view: _, ...live } = marked;
  expect(groupsOf({ findings: [], marked: [live] } as unknown as Inspection)[0]!.lead.view).toBe(-1);
});

test('a finding is settled once nothing remains to be done about it', () => {
  const settled = (verdict?: Verdict) => {
    const decision = verdict && { verdict, note: '', person: 'Ann', decided_at: '2025-01-01T12:00:00Z', round: 1 };
    return isSettled(groups(finding(1, decision ? { decision } : {}))[0]!);
  };
  for (const verdict of [undefined, 'debris', 'second-look'] as const) expect(settled(verdict), verdict ?? 'none').toBe(false);
  for (const verdict of ['debris-removed', 'debris-unreachable', 'installed-work', 'false-alarm'] as const) expect(settled(verdict), verdict).toBe(true);
});

test('the next finding without a decision follows in the list, and after its end from the beginning', () => {
  const decision: Decision = { verdict: 'false-alarm', note: '', person: 'Ann', decided_at: '2025-01-01T12:00:00Z', round: 1 };
  const all = groups(finding(1), finding(2, { decision }), finding(3), finding(4, { decision }));
  const after = (number: number) => nextUndecided(all, number)?.lead.number;
  expect([0, 1, 2, 3, 4].map(after)).toEqual([1, 3, 3, 1, 1]);
  expect(nextUndecided(groups(finding(1)), 1)?.lead.number, 'the last one that is left').toBe(1);
  expect(nextUndecided(groups(finding(1, { decision })), 1)).toBeUndefined();
});

test('a swipe goes far and mostly sideways', () => {
  expect([swipeOf(140, 0, 400), swipeOf(-300, 149, 400), swipeOf(139, 0, 400), swipeOf(300, 160, 400), swipeOf(0, 300, 400)]).toEqual(['right', 'left', '', '', '']);
});
