// Decisions on findings, one or several at once, and the way back from the last one.
import { attempt, update } from '../inspection/inspections';
import { api } from '../link/api';
import { person } from '../link/client';
import { Store } from '../store';
import type { GivenDecision, Inspection, Session, Verdict } from '../types';
import { decisionOf, groupsOf, nextUndecided, type Group } from './groups';
import { review, selectionOf, show } from './review_state';

export const verdicts: Verdict[] = ['debris', 'debris-removed', 'debris-unreachable', 'installed-work', 'false-alarm', 'second-look'];

/** The last decision, with what it replaced. */
export interface LastDecision {
  inspection: number;
  comparison: number | undefined;
  verdict: Verdict;
  groups: { number: number; label: number }[];
  before: GivenDecision[];
}

export const lastDecision = new Store<LastDecision | null>(null);

type Given = Pick<GivenDecision, 'verdict' | 'note' | 'object'>;

function given(group: Group, { verdict, note, object }: Given): GivenDecision[] {
  const decision: Given = object ? { verdict, note, object } : { verdict, note };
  if (group.marked) return [{ mark: group.marked.number, ...decision }];
  return group.all.map((finding) => ({ finding: finding.number, ...decision }));
}

function personOf(inspection: Inspection, session: Session): string {
  return session.name || person.name || inspection.person;
}

/** Selects the next finding without a decision, if there is one. */
export function goOn(inspection: Inspection): void {
  const next = nextUndecided(groupsOf(inspection), review.value.group);
  if (next) show(selectionOf(next));
}

/**
 * Decides on all of these findings or, where the server refuses one, on none, and goes on to the next one.
 * @param object what they are, as the person named it; empty where the person did not
 */
export async function decide(inspection: Inspection, groups: Group[], verdict: Verdict, note: string, session: Session, object = ''): Promise<boolean> {
  return attempt(async () => {
    const decisions = groups.flatMap((group) => given(group, { verdict, note, object }));
    const before = groups.flatMap((group) => given(group, decisionOf(group) ?? { verdict: 'undecided', note: '' }));
    const after = await api.decideAll(inspection, decisions, personOf(inspection, session));
    const numbers = groups.map(({ lead, label }) => ({ number: lead.number, label }));
    lastDecision.value = { inspection: inspection.id, comparison: inspection.comparison, verdict, groups: numbers, before };
    update(after);
    goOn(after);
  });
}

/** Whether the last decision belongs to what is shown and can be taken back. */
export function canUndo(last: LastDecision | null, inspection: Inspection): last is LastDecision {
  return last !== null && last.inspection === inspection.id && last.comparison === inspection.comparison && !inspection.closing;
}

/** Decides as it was decided before, or withdraws the decision where there was none; the record contains both. */
export async function undo(inspection: Inspection, last: LastDecision, session: Session): Promise<boolean> {
  return attempt(async () => {
    update(await api.decideAll(inspection, last.before, personOf(inspection, session)));
    lastDecision.value = null;
    const first = groupsOf(inspection).find((group) => group.lead.number === last.groups[0]?.number);
    if (first) show(selectionOf(first));
  });
}

/** Whether a key is meant for a field in which something is written, or is part of a shortcut of the browser. */
export function isWriting({ target }: Event): boolean {
  return target instanceof HTMLInputElement || target instanceof HTMLTextAreaElement || target instanceof HTMLSelectElement;
}
