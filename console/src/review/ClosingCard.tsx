// What comes after the decisions: capturing again, or closing the inspection by name.
import { useState } from 'preact/hooks';
import { attempt, openInspection } from '../inspection/inspections';
import { timeOf } from '../inspection/words';
import { api } from '../link/api';
import { person } from '../link/client';
import { link } from '../link/live_link';
import { useStore } from '../store';
import type { Inspection, Session } from '../types';
import { groupsOf, isSettled } from './groups';

function CaptureAgain({ inspection, session, first }: { inspection: Inspection; session: Session; first: boolean }) {
  const simulation = useStore(link.status)?.simulation ?? false;
  const removed = inspection.closing_needs_note;
  const again = () =>
    void attempt(async () => {
      if (simulation && removed) await api.simulateWork(false);
      await api.capture(inspection.id, 'final', session.name || person.name || inspection.person, false);
    });
  return (
    <button type="button" class={first ? 'primary' : ''} data-testid="capture-again" disabled={session.role === 'viewer'} onClick={again}>
      Capture again{simulation && removed ? ' (the simulated bay is tidied up)' : ''}
    </button>
  );
}

function CloseForm({ inspection, session, needsNote, onLeave }: { inspection: Inspection; session: Session; needsNote: boolean; onLeave: () => void }) {
  const [note, setNote] = useState('');
  const [name, setName] = useState(session.name || person.name || inspection.person);
  const close = (event: Event) => {
    event.preventDefault();
    void attempt(async () => {
      openInspection.value = await api.close(inspection, note.trim(), name.trim());
    });
  };
  return (
    <form class="stack" onSubmit={close} aria-label="Close the inspection" data-testid="close-form">
      <p>I have reviewed the pictures of every view. Nothing can be changed after the inspection is closed.</p>
      {!session.name && (
        <label class="field">
          <span>Your name</span>
          <input value={name} maxLength={100} required onInput={(event) => setName(event.currentTarget.value)} />
        </label>
      )}
      <label class="field">
        <span>
          Note{needsNote && <em> (required: debris was removed after these pictures, or cannot be reached)</em>}
        </span>
        <textarea rows={2} maxLength={1000} value={note} required={needsNote} onInput={(event) => setNote(event.currentTarget.value)} />
      </label>
      <div class="panel-pair">
        <button type="submit" class="primary" data-testid="close-confirm" disabled={name.trim() === '' || (needsNote && note.trim() === '')}>
          Close by name
        </button>
        <button type="button" onClick={onLeave}>
          Not yet
        </button>
      </div>
    </form>
  );
}

function Closed({ inspection }: { inspection: Inspection }) {
  const { closing } = inspection;
  if (!closing) return null;
  return (
    <div class="panel-action" data-testid="closed" role="status">
      <p class="good">
        ✓ Closed by {closing.person}, {timeOf(closing.closed_at)}.
      </p>
      {closing.note && <q>{closing.note}</q>}
    </div>
  );
}

// What is to be done before the inspection can be closed.
function remainder(inspection: Inspection): string {
  const open = groupsOf(inspection).filter((group) => !isSettled(group));
  const debris = open.filter((group) => group.lead.decision?.verdict === 'debris').length;
  const looks = open.filter((group) => group.lead.decision?.verdict === 'second-look').length;
  const undecided = open.length - debris - looks;
  const parts = [
    undecided > 0 ? `${undecided} to be decided` : '',
    debris > 0 ? `${debris} to be removed` : '',
    looks > 0 ? `${looks} to be looked at again` : '',
  ];
  return parts.filter((part) => part !== '').join(', ');
}

export function ClosingCard({ inspection, session }: { inspection: Inspection; session: Session }) {
  const [closing, setClosing] = useState(false);
  if (inspection.closing) return <Closed inspection={inspection} />;
  const left = remainder(inspection);
  const needsNote = inspection.closing_needs_note;
  if (closing && left === '') {
    return (
      <div class="panel-action">
        <CloseForm inspection={inspection} session={session} needsNote={needsNote} onLeave={() => setClosing(false)} />
      </div>
    );
  }
  return (
    <div class="panel-action">
      <p data-testid="all-decided" class={left === '' && !needsNote ? 'good' : 'open'}>
        {left !== '' ? `Before closing: ${left}.` : needsNote ? 'Debris was removed after these pictures, or cannot be reached: capture again to see that it is gone.' : '✓ Nothing remains to be decided.'}
      </p>
      <div class="panel-pair narrow">
        <CaptureAgain inspection={inspection} session={session} first={left === '' && needsNote} />
        <button type="button" class={left === '' && !needsNote ? 'primary' : ''} data-testid="close" disabled={left !== '' || session.role !== 'inspector'} onClick={() => setClosing(true)}>
          Close inspection
        </button>
      </div>
    </div>
  );
}
