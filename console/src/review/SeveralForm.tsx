// One decision on several findings.
import { useState } from 'preact/hooks';
import { useStore } from '../store';
import type { Inspection, Session, Verdict } from '../types';
import { decide } from './decisions';
import { decisionOf, type Group } from './groups';
import { several } from './review_state';
import { Verdicts } from './Verdicts';
import { Rich } from '../words/Rich';
import { words } from '../words/words';

export function toggleSeveral(number: number): void {
  const now = several.value ?? [];
  several.value = now.includes(number) ? now.filter((other) => other !== number) : [...now, number];
}

export function SeveralForm({ inspection, groups, session }: { inspection: Inspection; groups: Group[]; session: Session }) {
  const numbers = useStore(several) ?? [];
  const [note, setNote] = useState('');
  // Until then, the room is for the list.
  const [deciding, setDeciding] = useState(false);
  const chosen = groups.filter((group) => numbers.includes(group.lead.number));
  const undecided = groups.filter((group) => !decisionOf(group)).map((group) => group.lead.number);
  const pick = (verdict: Verdict) =>
    void decide(inspection, chosen, verdict, note, session).then((done) => {
      if (done) several.value = null;
    });
  return (
    <div class="panel-action" role="group" aria-label={words.review.decideSeveral} data-testid="several-form">
      <p role="status">
        <Rich text={words.review.selected(chosen.length, groups.length)} />
      </p>
      {deciding ? (
        <>
          <Verdicts chosen={undefined} enabled={chosen.length > 0} onPick={pick} />
          <label class="field">
            <span>{words.review.noteForAll}</span>
            <input value={note} maxLength={1000} onInput={(event) => setNote(event.currentTarget.value)} />
          </label>
        </>
      ) : (
        <button type="button" class="primary" data-testid="several-decide" disabled={chosen.length === 0} onClick={() => setDeciding(true)}>
          {words.review.decideOn(chosen.length)}
        </button>
      )}
      <div class="panel-pair narrow">
        <button type="button" data-testid="several-undecided" disabled={undecided.length === 0} onClick={() => (several.value = undecided)}>
          {words.review.selectAllUndecided}
        </button>
        <button type="button" data-testid="several-cancel" onClick={() => (several.value = null)}>
          {words.page.cancel}
        </button>
      </div>
    </div>
  );
}
