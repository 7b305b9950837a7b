// What the terms mean, behind a question mark: those of the page first, and then its keys.
import './glossary.css';
import { useRef } from 'preact/hooks';
import type { Page } from '../pages';
import type { Key, Term } from './en';
import { Rich } from './Rich';
import { words } from './words';

/** The terms that each page uses; 'list' is the list of inspections. */
const termsOf: Record<Page | 'list', Term[]> = {
  list: ['baseline', 'finding', 'decision', 'close', 'lease', 'panTilt', 'depth'],
  live: ['view', 'capture', 'baseline', 'baselineCheck', 'level', 'height', 'noise', 'depth', 'approach', 'lease', 'panTilt', 'deadZone', 'leftOut', 'marked'],
  regions: ['leftOut', 'coverage', 'view', 'baseline', 'comparison'],
  plan: ['planned', 'installed', 'finding', 'view', 'baseline', 'comparison'],
  review: ['finding', 'planned', 'suspicion', 'height', 'decision', 'debris', 'installed', 'falseAlarm', 'coverage', 'level', 'marked', 'view', 'round', 'comparison', 'close'],
  space: ['finding', 'depth', 'view', 'comparison'],
};

/** The keys of each page. Those for driving work on all of them. */
const keysOf: Record<Page | 'list', Key[]> = {
  list: ['picture', 'drive', 'stop'],
  live: ['picture', 'drive', 'stop'],
  regions: ['region', 'drive', 'stop'],
  plan: ['picture', 'drive', 'stop'],
  review: ['decide', 'next', 'undo', 'picture', 'drive', 'stop'],
  space: ['turn', 'move', 'zoom', 'all', 'next', 'decide', 'undo', 'drive', 'stop'],
};

function Keys({ keys }: { keys: Key[] }) {
  return (
    <>
      <h3>{words.glossary.keysTitle}</h3>
      <ul>
        {keys.map((key) => (
          <li key={key} data-testid={`key-${key}`}>
            <Rich text={words.glossary.keys[key]} />
          </li>
        ))}
      </ul>
    </>
  );
}

function Terms({ title, terms }: { title: string; terms: Term[] }) {
  return (
    <>
      <h3>{title}</h3>
      <dl>
        {terms.map((term) => (
          <div key={term} data-testid={`term-${term}`}>
            <dt>{words.glossary.terms[term][0]}</dt>
            <dd>{words.glossary.terms[term][1]}</dd>
          </div>
        ))}
      </dl>
    </>
  );
}

// Keys scroll the terms and do not turn the camera or decide meanwhile. Escape, which closes them, also stops the robot.
function keepKeys(event: KeyboardEvent): void {
  if (event.key !== 'Escape') event.stopPropagation();
}

export function Glossary({ page }: { page: Page | 'list' }) {
  const dialog = useRef<HTMLDialogElement>(null);
  const close = () => dialog.current?.close();
  const here = termsOf[page];
  const further = (Object.keys(words.glossary.terms) as Term[]).filter((term) => !here.includes(term));
  return (
    <>
      <button type="button" class="quiet glossary-open" aria-label={`? ${words.glossary.open}`} aria-haspopup="dialog" data-testid="glossary-open" onClick={() => dialog.current?.showModal()}>
        ?
      </button>
      <dialog
        ref={dialog}
        class="glossary"
        aria-label={words.glossary.title}
        data-testid="glossary"
        onKeyDown={keepKeys}
        onClick={(event) => event.target === dialog.current && close()}
      >
        <div class="glossary-head">
          <h2>{words.glossary.title}</h2>
          <button type="button" data-testid="glossary-close" onClick={close}>
            {words.page.close}
          </button>
        </div>
        <Terms title={words.glossary.here} terms={here} />
        <Keys keys={keysOf[page]} />
        <Terms title={words.glossary.more} terms={further} />
      </dialog>
    </>
  );
}
