// The sign-in form, shown if the server has accounts.
import './SignIn.css';
import { useState } from 'preact/hooks';
import { attempt, trouble } from './inspection/inspections';
import { api } from './link/api';
import { useStore } from './store';
import { LanguageChoice } from './words/LanguageChoice';
import { RefusalText } from './words/RefusalText';
import { words } from './words/words';

export function SignIn({ onSignedIn }: { onSignedIn: () => void }) {
  const [name, setName] = useState('');
  const [password, setPassword] = useState('');
  const refused = useStore(trouble);
  const submit = async (event: Event) => {
    event.preventDefault();
    if (await attempt(() => api.signIn(name, password))) onSignedIn();
    else setPassword('');
  };
  return (
    <main class="sign-in">
      <form class="card" onSubmit={(event) => void submit(event)}>
        <div class="sign-in-head">
          <h1>RVA</h1>
          <LanguageChoice />
        </div>
        <label class="field">
          <span>{words.signIn.name}</span>
          <input value={name} autocomplete="username" onInput={(event) => setName(event.currentTarget.value)} />
        </label>
        <label class="field">
          <span>{words.signIn.password}</span>
          <input type="password" value={password} autocomplete="current-password" onInput={(event) => setPassword(event.currentTarget.value)} />
        </label>
        {refused && (
          <p class="bad" role="alert">
            <RefusalText refusal={refused} />
          </p>
        )}
        <button type="submit" class="primary big" data-testid="sign-in" disabled={name === '' || password === ''}>
          {words.signIn.signIn}
        </button>
      </form>
    </main>
  );
}
