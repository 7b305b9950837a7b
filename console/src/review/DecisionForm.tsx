// The decision on a finding.
import type { ComponentChildren } from 'preact';
import { useEffect, useState } from 'preact/hooks';
import { api } from '../link/api';
import { person } from '../link/client';
import { attempt, openInspection } from '../inspection/inspections';
import { timeOf, verdictNames } from '../inspection/words';
import type { Inspection, Session, Verdict } from '../types';
import { decisionOf, groupsOf, type Group } from './groups';
import { selectionOf, show } from './review_state';

const verdicts: Verdict[] = ['debris', 'debris-removed', 'debris-unreachable', 'installed-work', 'false-alarm', 'second-look'];

// Selects the next undecided finding. Debris that is still there stays selected, since its removal comes next.
function goOn(inspection: Inspection, verdict: Verdict): void {
  if (verdict === 'debris') return;
  const next = groupsOf(inspection).find((group) => !decisionOf(group));
  if (next) show(selectionOf(next));
}

/** @param children pictures, between the verdicts, which are in reach at once, and the note */
export function DecisionForm({ inspection, group, session, children }: { inspection: Inspection; group: Group; session: Session; children: ComponentChildren }) {
  const before = decisionOf(group);
  const [note, setNote] = useState(before?.note ?? '');
  useEffect(() => setNote(before?.note ?? ''), [group.lead.number]);
  const closed = inspection.closing !== undefined;
  const mayDecide = session.role === 'inspector' && !closed;
  const decide = (verdict: Verdict) =>
    void attempt(async () => {
      const who = session.name || person.name || inspection.person;
      let after = inspection;
      if (group.marked) after = await api.decideMark(inspection.id, group.marked.number, verdict, note, who);
      else for (const finding of group.all) after = await api.decide(inspection, finding.number, verdict, note, who);
      openInspection.value = after;
      goOn(after, verdict);
    });
  // A digit decides, as long as nothing is being written.
  useEffect(() => {
    const press = (event: KeyboardEvent) => {
      const verdict = verdicts[Number(event.key) - 1];
      const writes = event.target instanceof HTMLInputElement || event.target instanceof HTMLTextAreaElement || event.target instanceof HTMLSelectElement;
      if (verdict && mayDecide && !writes && !event.ctrlKey && !event.altKey && !event.metaKey) decide(verdict);
    };
    addEventListener('keydown', press);
    return () => removeEventListener('keydown', press);
  });
  return (
    <div class="decision" data-testid="decision">
      <div class="verdicts">
        {verdicts.map((verdict, i) => (
          <button
            key={verdict}
            type="button"
            class={before?.verdict === verdict ? 'chosen' : ''}
            aria-pressed={before?.verdict === verdict}
            disabled={!mayDecide}
            aria-keyshortcuts={String(i + 1)}
            data-testid={`verdict-${verdict}`}
            onClick={() => decide(verdict)}
          >
            {verdictNames[verdict]}
          </button>
        ))}
      </div>
      {children}
      <label class="field">
        <span>Note</span>
        <textarea rows={2} maxLength={1000} value={note} disabled={!mayDecide} onInput={(event) => setNote(event.currentTarget.value)} />
      </label>
      {!mayDecide && !closed && <p class="hint">Only an inspector can decide.</p>}
      {before && (
        <p class="hint">
          {verdictNames[before.verdict]}: {before.person}, {timeOf(before.decided_at)}
        </p>
      )}
    </div>
  );
}
