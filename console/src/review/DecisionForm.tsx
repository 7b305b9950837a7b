// The decision on a finding.
import { useEffect, useState } from 'preact/hooks';
import { api } from '../link/api';
import { person } from '../link/client';
import { attempt, openInspection } from '../inspection/inspections';
import { timeOf, verdictNames } from '../inspection/words';
import type { Inspection, Session, Verdict } from '../types';
import { decisionOf, groupsOf, type Group } from './groups';
import { show } from './review_state';

const verdicts: Verdict[] = ['debris-removed', 'installed-work', 'false-alarm', 'second-look'];

// Selects the next undecided finding.
function goOn(inspection: Inspection): void {
  const next = groupsOf(inspection).find((group) => !decisionOf(group));
  if (next) show({ group: next.lead.number, view: next.lead.view });
}

export function DecisionForm({ inspection, group, session }: { inspection: Inspection; group: Group; session: Session }) {
  const before = decisionOf(group);
  const [note, setNote] = useState(before?.note ?? '');
  useEffect(() => setNote(before?.note ?? ''), [group.lead.number]);
  const mayDecide = session.role === 'inspector';
  const decide = (verdict: Verdict) =>
    void attempt(async () => {
      const who = session.name || person.name || inspection.person;
      let after = inspection;
      for (const finding of group.all) after = await api.decide(inspection, finding.number, verdict, note, who);
      openInspection.value = after;
      goOn(after);
    });
  return (
    <div class="decision" data-testid="decision">
      <label class="field">
        <span>Note</span>
        <textarea rows={2} maxLength={1000} value={note} disabled={!mayDecide} onInput={(event) => setNote(event.currentTarget.value)} />
      </label>
      <div class="verdicts">
        {verdicts.map((verdict) => (
          <button
            key={verdict}
            type="button"
            class={before?.verdict === verdict ? 'chosen' : ''}
            aria-pressed={before?.verdict === verdict}
            disabled={!mayDecide}
            data-testid={`verdict-${verdict}`}
            onClick={() => decide(verdict)}
          >
            {verdictNames[verdict]}
          </button>
        ))}
      </div>
      {!mayDecide && <p class="hint">Only an inspector can decide.</p>}
      {before && (
        <p class="hint">
          {verdictNames[before.verdict]}: {before.person}, {timeOf(before.decided_at)}
        </p>
      )}
    </div>
  );
}
