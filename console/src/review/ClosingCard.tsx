// What comes after the decisions: capturing again, or closing the inspection by name and signing it.
import { useState } from 'preact/hooks';
import { unaccounted } from '../checkout/items';
import { attempt, update } from '../inspection/inspections';
import { timeOf } from '../inspection/words';
import { api, pdfReportAddress, reportAddress } from '../link/api';
import { person } from '../link/client';
import { link } from '../link/live_link';
import { useStore } from '../store';
import type { Inspection, Session } from '../types';
import { groupsOf, isSettled } from './groups';
import { isComplete, nobody, SignerFields } from './SignerFields';
import { maySign, Signing } from './Signing';
import { words } from '../words/words';

function CaptureAgain({ inspection, session, first }: { inspection: Inspection; session: Session; first: boolean }) {
  const simulation = useStore(link.status)?.simulation ?? false;
  const removed = inspection.closing_note_for.includes('debris');
  const again = () =>
    void attempt(async () => {
      if (simulation && removed) await api.simulateWork(false);
      await api.capture(inspection.id, 'final', session.name || person.name || inspection.person, false);
    });
  return (
    <button type="button" class={first ? 'primary' : ''} data-testid="capture-again" disabled={session.role === 'viewer'} onClick={again}>
      {simulation && removed ? words.review.captureAgainTidied : words.review.captureAgain}
    </button>
  );
}

function CloseForm({ inspection, session, onLeave }: { inspection: Inspection; session: Session; onLeave: () => void }) {
  const needsNote = inspection.closing_needs_note;
  const [note, setNote] = useState('');
  const [name, setName] = useState(session.name || person.name || inspection.person);
  const [request, setRequest] = useState(nobody);
  const signs = maySign(session);
  const isFilledIn = name.trim() !== '' && !(needsNote && note.trim() === '') && (!signs || isComplete(request));
  // Where a password is wrong, the inspection is closed, and can still be signed.
  const close = (event: Event) => {
    event.preventDefault();
    void attempt(async () => {
      const closed = await api.close(inspection, note.trim(), name.trim());
      update(closed);
      if (signs) await api.sign(closed, request);
    });
  };
  return (
    <form class="stack" onSubmit={close} aria-label={words.review.closeTheInspection} data-testid="close-form">
      <p>{words.review.reviewed}</p>
      {!session.name && (
        <label class="field">
          <span>{words.page.yourName}</span>
          <input value={name} maxLength={100} required onInput={(event) => setName(event.currentTarget.value)} />
        </label>
      )}
      <label class="field">
        <span>
          {words.review.note}{needsNote && <em> {words.review.noteRequired(inspection.closing_note_for.map((reason) => words.review.closingReasons[reason]).join('; '))}</em>}
        </span>
        <textarea rows={2} maxLength={1000} value={note} required={needsNote} onInput={(event) => setNote(event.currentTarget.value)} />
      </label>
      {signs && <SignerFields session={session} request={request} onChange={setRequest} />}
      <div class="panel-pair">
        <button type="submit" class="primary" data-testid="close-confirm" disabled={!isFilledIn}>
          {signs ? words.review.closeAndSign : words.review.closeByName}
        </button>
        <button type="button" onClick={onLeave}>
          {words.review.notYet}
        </button>
      </div>
    </form>
  );
}

function Closed({ inspection, session }: { inspection: Inspection; session: Session }) {
  const { closing } = inspection;
  if (!closing) return null;
  return (
    <div class="panel-action" data-testid="closed" role="status">
      <p class="good">{words.review.closed(closing.person, timeOf(closing.closed_at))}</p>
      {closing.note && <q>{closing.note}</q>}
      <Signing inspection={inspection} session={session} />
      <a class="button" href={reportAddress(inspection)} target="_blank" rel="noreferrer" data-testid="report">
        {words.review.report}
      </a>
      <a class="button" href={pdfReportAddress(inspection)} target="_blank" rel="noreferrer" data-testid="pdf-report">
        {words.review.pdfReport}
      </a>
    </div>
  );
}

// What is to be done before the inspection can be closed.
function remainder(inspection: Inspection): string {
  const open = groupsOf(inspection).filter((group) => !isSettled(group));
  const debris = open.filter((group) => group.lead.decision?.verdict === 'debris').length;
  const looks = open.filter((group) => group.lead.decision?.verdict === 'second-look').length;
  const undecided = open.length - debris - looks;
  const items = unaccounted(inspection).length;
  const parts = [
    undecided > 0 ? words.review.toDecide(undecided) : '',
    debris > 0 ? words.review.toRemove(debris) : '',
    looks > 0 ? words.review.toLookAtAgain(looks) : '',
    items > 0 ? words.review.toAccountFor(items) : '',
  ];
  return parts.filter((part) => part !== '').join(', ');
}

export function ClosingCard({ inspection, session }: { inspection: Inspection; session: Session }) {
  const [closing, setClosing] = useState(false);
  if (inspection.closing) return <Closed inspection={inspection} session={session} />;
  const left = remainder(inspection);
  const needsNote = inspection.closing_needs_note;
  if (closing && left === '') {
    return (
      <div class="panel-action">
        <CloseForm inspection={inspection} session={session} onLeave={() => setClosing(false)} />
      </div>
    );
  }
  return (
    <div class="panel-action">
      <p data-testid="all-decided" class={left === '' && !needsNote ? 'good' : 'open'}>
        {left !== '' ? words.review.remains(left) : needsNote ? words.review.captureFor[inspection.closing_note_for[0]!] : words.review.nothingLeft}
      </p>
      <div class="panel-pair narrow">
        <CaptureAgain inspection={inspection} session={session} first={left === '' && needsNote} />
        <button type="button" class={left === '' && !needsNote ? 'primary' : ''} data-testid="close" disabled={left !== '' || session.role !== 'inspector'} onClick={() => setClosing(true)}>
          {maySign(session) ? words.review.closeAndSign : words.review.close}
        </button>
      </div>
    </div>
  );
}
