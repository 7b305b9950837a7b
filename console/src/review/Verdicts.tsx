// One button for each verdict; the digits 1 to 6 press them.
import { useLayoutEffect } from 'preact/hooks';
import type { Verdict } from '../types';
import { isWriting, verdicts } from './decisions';
import { words } from '../words/words';

interface Props {
  chosen: Verdict | undefined;
  enabled: boolean;
  onPick: (verdict: Verdict) => void;
}

export function Verdicts({ chosen, enabled, onPick }: Props) {
  // A digit decides, as long as nothing is being written. Listening begins before the page is painted: a press in between would
  // decide on the finding before, or be lost.
  useLayoutEffect(() => {
    const press = (event: KeyboardEvent) => {
      const verdict = verdicts[Number(event.key) - 1];
      if (verdict && enabled && !event.repeat && !isWriting(event) && !event.ctrlKey && !event.altKey && !event.metaKey) onPick(verdict);
    };
    addEventListener('keydown', press);
    return () => removeEventListener('keydown', press);
  });
  return (
    <div class="verdicts">
      {verdicts.map((verdict, i) => (
        <button
          key={verdict}
          type="button"
          class={chosen === verdict ? 'chosen' : ''}
          aria-pressed={chosen === verdict}
          disabled={!enabled}
          aria-keyshortcuts={String(i + 1)}
          data-testid={`verdict-${verdict}`}
          onClick={() => onPick(verdict)}
        >
          <kbd aria-hidden="true">{i + 1}</kbd> {words.finding.verdicts[verdict]}
        </button>
      ))}
    </div>
  );
}
