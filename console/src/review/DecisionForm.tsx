// The decision on a finding.
import type { ComponentChildren } from 'preact';
import { useLayoutEffect, useState } from 'preact/hooks';
import { className, timeOf } from '../inspection/words';
import type { Inspection, Session } from '../types';
import { decide } from './decisions';
import { decisionOf, type Group } from './groups';
import { ObjectChoice } from './ObjectChoice';
import { Verdicts } from './Verdicts';
import { words } from '../words/words';

/** @param children pictures, between the verdicts, which are in reach at once, and the note */
export function DecisionForm({ inspection, group, session, children }: { inspection: Inspection; group: Group; session: Session; children: ComponentChildren }) {
  const before = decisionOf(group);
  const [note, setNote] = useState(before?.note ?? '');
  const [object, setObject] = useState(before?.object ?? '');
  // Before the page is painted, since afterwards it would undo what a person has entered in the meantime.
  useLayoutEffect(() => setNote(before?.note ?? ''), [group.lead.number, before?.note]);
  useLayoutEffect(() => setObject(before?.object ?? ''), [group.lead.number, before?.object]);
  const closed = inspection.closing !== undefined;
  const mayDecide = session.role === 'inspector' && !closed;
  return (
    <div class="decision" data-testid="decision">
      <Verdicts chosen={before?.verdict} enabled={mayDecide} onPick={(verdict) => void decide(inspection, [group], verdict, note, session, object)} />
      {mayDecide && <p class="hint swipe-help">{words.review.swipe}</p>}
      {mayDecide && <p class="hint key-help">{words.review.keys}</p>}
      {children}
      <ObjectChoice chosen={object} enabled={mayDecide} onPick={setObject} />
      <label class="field">
        <span>{words.review.note}</span>
        <textarea rows={2} maxLength={1000} value={note} disabled={!mayDecide} onInput={(event) => setNote(event.currentTarget.value)} />
      </label>
      {!mayDecide && !closed && <p class="hint">{words.review.onlyInspector}</p>}
      {before && (
        <p class="hint">
          {words.finding.verdicts[before.verdict]}
          {before.object && ` (${className(before.object)})`}: {before.person}, {timeOf(before.decided_at)}
        </p>
      )}
    </div>
  );
}
