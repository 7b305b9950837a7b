// The styles of all pages come first, so that those of a component can refine them.
import './theme.css';
import './base.css';
import './panel.css';
import './picture.css';
import './switch.css';
import { render } from 'preact';
import { useEffect, useState } from 'preact/hooks';
import { App } from './App';
import { sticks } from './drive/sticks';
import { followAddress, openAddress } from './follow_address';
import { followTasks } from './inspection/inspections';
import { followInspection } from './regions/region_state';
import { api } from './link/api';
import { link } from './link/live_link';
import { refusalOf, type Refusal } from './link/refusal';
import { followRounds } from './review/rounds';
import { SignIn } from './SignIn';
import { useStore } from './store';
import { followTheme } from './theme';
import type { Session } from './types';
import { beginLanguage, language } from './words/language';
import { RefusalText } from './words/RefusalText';
import { words } from './words/words';

function Console() {
  const [session, setSession] = useState<Session | null>(null);
  const [problem, setProblem] = useState<Refusal | null>(null);
  // Another language draws everything again.
  useStore(language);
  const ask = () =>
    api.session().then(
      (answer) => {
        setProblem(null);
        setSession(answer);
      },
      (error: unknown) => {
        setProblem(refusalOf(error));
        setTimeout(ask, 1000);
      },
    );
  useEffect(() => void ask(), []);
  const known = session?.role !== undefined;
  useEffect(() => {
    if (!known) return;
    link.start();
    sticks.start();
    followTasks();
    followInspection();
    followRounds();
    void openAddress().then(followAddress, followAddress);
  }, [known]);
  if (problem)
    return (
      <p class="alone" role="alert">
        <RefusalText refusal={problem} />
      </p>
    );
  if (!session) return <p class="alone">{words.page.loading}</p>;
  if (!session.role) return <SignIn onSignedIn={() => void ask()} />;
  return <App session={session} onSignedOut={() => location.reload()} />;
}

followTheme();
const root = document.getElementById('console');
if (root) void beginLanguage().then(() => render(<Console />, root));
