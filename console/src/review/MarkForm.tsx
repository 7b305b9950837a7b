// Asks what a person has marked, and saves it as a finding.
import { useState } from 'preact/hooks';
import { person } from '../link/client';
import { useStore } from '../store';
import type { Inspection, Session } from '../types';
import { newMark, saveMark } from './marks';
import { words } from '../words/words';

export function MarkForm({ inspection, session }: { inspection: Inspection; session: Session }) {
  const mark = useStore(newMark);
  const [note, setNote] = useState('');
  if (!mark) return null;
  const save = (event: Event) => {
    event.preventDefault();
    void saveMark(inspection, mark, note, session.name || person.name || inspection.person).then(() => setNote(''));
  };
  return (
    <form class="panel-action" onSubmit={save} data-testid="mark-form" aria-label={words.review.markedFinding}>
      <label class="field">
        <span>{words.review.whatIsMarked}</span>
        <input value={note} maxLength={1000} onInput={(event) => setNote(event.currentTarget.value)} />
      </label>
      <div class="panel-pair">
        <button type="submit" class="primary" data-testid="mark-save">
          {words.review.saveAsFinding}
        </button>
        <button type="button" data-testid="mark-discard" onClick={() => (newMark.value = null)}>
          {words.page.discard}
        </button>
      </div>
    </form>
  );
}
