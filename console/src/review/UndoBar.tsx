// What was decided last, with the way back; for a few keys as well.
import { useLayoutEffect } from 'preact/hooks';
import { useStore } from '../store';
import type { Inspection, Session } from '../types';
import { canUndo, goOn, isWriting, lastDecision, undo } from './decisions';
import { words } from '../words/words';

export function UndoBar({ inspection, session }: { inspection: Inspection; session: Session }) {
  const last = useStore(lastDecision);
  const possible = canUndo(last, inspection);
  useLayoutEffect(() => {
    const press = (event: KeyboardEvent) => {
      if (isWriting(event) || event.altKey) return;
      const control = event.ctrlKey || event.metaKey;
      if (possible && control && !event.shiftKey && event.key.toLowerCase() === 'z') void undo(inspection, last, session);
      else if (!control && event.key.toLowerCase() === 'n') goOn(inspection);
      else return;
      event.preventDefault();
    };
    addEventListener('keydown', press);
    return () => removeEventListener('keydown', press);
  });
  if (!possible) return null;
  const labels = last.groups.map(({ label }) => label);
  return (
    <div class="undo" role="status" data-testid="undo-bar">
      <span>{words.review.undone(labels, words.finding.verdicts[last.verdict])}</span>
      <button type="button" aria-keyshortcuts="Control+Z" data-testid="undo" onClick={() => void undo(inspection, last, session)}>
        {words.review.undo}
      </button>
    </div>
  );
}
