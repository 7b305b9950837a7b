// Asks for a note on a picture that is kept with the inspection.
import { useState } from 'preact/hooks';
import { attempt, update } from '../inspection/inspections';
import { api } from '../link/api';
import { person } from '../link/client';
import { Store, useStore } from '../store';
import type { Inspection, Session, Stream } from '../types';
import { words } from '../words/words';

/** The picture to be kept: a frozen one, or the newest of a stream. */
export const newSnapshot = new Store<{ stream: Stream; frozen?: number } | null>(null);

export function SnapshotForm({ inspection, session }: { inspection: Inspection; session: Session }) {
  const picture = useStore(newSnapshot);
  const [note, setNote] = useState('');
  if (!picture) return null;
  const save = (event: Event) => {
    event.preventDefault();
    void attempt(async () => {
      update(await api.keepSnapshot(inspection.id, { ...picture, note, person: session.name || person.name || inspection.person }));
      newSnapshot.value = null;
      setNote('');
    });
  };
  return (
    <form class="panel-action" onSubmit={save} data-testid="snapshot-form" aria-label={words.live.snapshot}>
      <label class="field">
        <span>{words.live.snapshotNote}</span>
        <input value={note} maxLength={1000} onInput={(event) => setNote(event.currentTarget.value)} />
      </label>
      <div class="panel-pair">
        <button type="submit" class="primary" data-testid="snapshot-save">
          {words.live.snapshotKeep}
        </button>
        <button type="button" data-testid="snapshot-discard" onClick={() => (newSnapshot.value = null)}>
          {words.page.discard}
        </button>
      </div>
    </form>
  );
}
