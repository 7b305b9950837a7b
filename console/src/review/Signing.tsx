// The signatures of a closed inspection, and the form for signing it.
import { useState } from 'preact/hooks';
import { CaptureProgress, Failure } from '../inspection/CaptureProgress';
import { attempt, isBusy } from '../inspection/inspections';
import { timeOf } from '../inspection/words';
import { api } from '../link/api';
import { link } from '../link/live_link';
import { useStore } from '../store';
import type { Inspection, Session, SignedPackage } from '../types';
import { words } from '../words/words';
import { isComplete, nobody, SignerFields } from './SignerFields';

/** The names in public keys, NAME+ID+BASE64. */
function namesOf({ signers }: SignedPackage): string {
  return signers.map((key) => key.slice(0, key.indexOf('+'))).join(', ');
}

function SignForm({ inspection, session, onLeave }: { inspection: Inspection; session: Session; onLeave: () => void }) {
  const [request, setRequest] = useState(nobody);
  const sign = (event: Event) => {
    event.preventDefault();
    void attempt(() => api.sign(inspection, request)).then((signed) => (signed ? onLeave() : setRequest({ ...request, password: '' })));
  };
  return (
    <form class="stack" onSubmit={sign} aria-label={words.review.sign} data-testid="sign-form">
      <SignerFields session={session} request={request} onChange={setRequest} />
      <div class="panel-pair">
        <button type="submit" class="primary" data-testid="sign-confirm" disabled={!isComplete(request)}>
          {words.review.sign}
        </button>
        <button type="button" onClick={onLeave}>
          {words.review.notYet}
        </button>
      </div>
    </form>
  );
}

/** Whether a person may sign here: with an account whose role may. */
export function maySign(session: Session): boolean {
  return Boolean(session.name) && session.role !== 'viewer';
}

export function Signing({ inspection, session }: { inspection: Inspection; session: Session }) {
  const packages = inspection.signed ?? [];
  const [signing, setSigning] = useState(false);
  const task = useStore(link.status)?.task;
  if (task && isBusy(task) && task.inspection === inspection.id) return <CaptureProgress task={task} mayCancel={maySign(session)} />;
  return (
    <>
      <Failure inspection={inspection} />
      {packages.map((signed) => (
        <p key={signed.folder} class={signed.signers.length > 0 ? 'good' : 'bad'} data-testid="signed">
          {signed.signers.length > 0
            ? words.review.signed(namesOf(signed), timeOf(signed.signed_at), signed.folder)
            : words.review.unreadablePackage(signed.folder)}
        </p>
      ))}
      {packages.length === 0 && <p class="open">{maySign(session) ? words.review.unsigned : words.review.signWithAccount}</p>}
      {maySign(session) &&
        (signing ? (
          <SignForm inspection={inspection} session={session} onLeave={() => setSigning(false)} />
        ) : (
          <button type="button" class={packages.length === 0 ? 'primary' : ''} data-testid="sign" onClick={() => setSigning(true)}>
            {packages.length === 0 ? words.review.sign : words.review.signAgain}
          </button>
        ))}
    </>
  );
}
