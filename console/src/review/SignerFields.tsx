// The passwords of the people at this console who sign an inspection.
import type { Session, SignRequest } from '../types';
import { words } from '../words/words';

/** The most people beside the one whose account is signed in. */
const most_others = 7;

function Password({ label, value, onInput }: { label: string; value: string; onInput: (value: string) => void }) {
  return (
    <label class="field">
      <span>{label}</span>
      <input type="password" autocomplete="off" maxLength={256} required value={value} onInput={(event) => onInput(event.currentTarget.value)} />
    </label>
  );
}

export const nobody: SignRequest = { password: '', others: [] };

export function isComplete({ password, others = [] }: SignRequest): boolean {
  return password !== '' && others.every((other) => other.name.trim() !== '' && other.password !== '');
}

export function SignerFields({ session, request, onChange }: { session: Session; request: SignRequest; onChange: (request: SignRequest) => void }) {
  const others = request.others ?? [];
  const change = (at: number, field: 'name' | 'password', value: string) =>
    onChange({ ...request, others: others.map((other, k) => (k === at ? { ...other, [field]: value } : other)) });
  return (
    <>
      <Password label={words.review.passwordOf(session.name ?? '')} value={request.password} onInput={(password) => onChange({ ...request, password })} />
      {others.map((other, at) => (
        <fieldset class="stack" key={at}>
          <legend>{words.review.anotherSigner}</legend>
          <label class="field">
            <span>{words.signIn.name}</span>
            <input value={other.name} maxLength={100} required onInput={(event) => change(at, 'name', event.currentTarget.value)} />
          </label>
          <Password label={words.signIn.password} value={other.password} onInput={(value) => change(at, 'password', value)} />
        </fieldset>
      ))}
      {others.length < most_others && (
        <button type="button" data-testid="add-signer" onClick={() => onChange({ ...request, others: [...others, { name: '', password: '' }] })}>
          {words.review.addSigner}
        </button>
      )}
    </>
  );
}
