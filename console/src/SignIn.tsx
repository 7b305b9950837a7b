// The sign-in form, shown if the server has accounts.
import './SignIn.css';
import { useState } from 'preact/hooks';
import { api, Refusal } from './link/api';
import { words } from './words/words';

export function SignIn({ onSignedIn }: { onSignedIn: () => void }) {
  const [name, setName] = useState('');
  const [password, setPassword] = useState('');
  const [problem, setProblem] = useState('');
  const submit = async (event: Event) => {
    event.preventDefault();
    try {
      await api.signIn(name, password);
      onSignedIn();
    } catch (error) {
      setPassword('');
      setProblem(error instanceof Refusal ? error.message : String(error));
    }
  };
  return (
    <main class="sign-in">
      <form class="card" onSubmit={(event) => void submit(event)}>
        <h1>RVA</h1>
        <label class="field">
          <span>{words.signIn.name}</span>
          <input value={name} autocomplete="username" onInput={(event) => setName(event.currentTarget.value)} />
        </label>
        <label class="field">
          <span>{words.signIn.password}</span>
          <input type="password" value={password} autocomplete="current-password" onInput={(event) => setPassword(event.currentTarget.value)} />
        </label>
        {problem && (
          <p class="bad" role="alert">
            {problem}
          </p>
        )}
        <button type="submit" class="primary big" data-testid="sign-in" disabled={name === '' || password === ''}>
          {words.signIn.signIn}
        </button>
      </form>
    </main>
  );
}
