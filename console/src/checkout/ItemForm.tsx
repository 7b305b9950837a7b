// What became of an item of the check-out list, by number.
import { useState } from 'preact/hooks';
import type { Item, ItemRequest, Session } from '../types';
import { words } from '../words/words';
import { statementOn } from './items';

type Statement = Omit<ItemRequest, 'person'>;

function Count({ label, value, most, onInput }: { label: string; value: number; most: number; onInput: (count: number) => void }) {
  return (
    <label class="field">
      <span>{label}</span>
      <input type="number" inputMode="numeric" min={0} max={most} required value={value} onInput={(event) => onInput(event.currentTarget.valueAsNumber || 0)} />
    </label>
  );
}

/** @param onState is called with what is stated; `onLeave` when nothing is */
export function ItemForm({ item, session, onState, onLeave }: { item: Item; session: Session; onState: (statement: Statement) => void; onLeave: () => void }) {
  const [stated, setStated] = useState<Statement>(() => statementOn(item));
  const set = (change: Partial<Statement>) => {
    const next = { ...stated, ...change };
    setStated({ ...next, released: next.released && next.lost > 0 });
  };
  const isPossible = stated.returned + stated.used + stated.lost <= item.quantity && !(stated.released && stated.note.trim() === '');
  const state = (event: Event) => {
    event.preventDefault();
    onState({ ...stated, note: stated.note.trim() });
  };
  return (
    <form class="stack" onSubmit={state} aria-label={words.checkout.whatBecameOf(item.name)} data-testid={`item-form-${item.number}`}>
      <Count label={words.checkout.returned} value={stated.returned} most={item.quantity} onInput={(returned) => set({ returned })} />
      <Count label={words.checkout.used} value={stated.used} most={item.quantity} onInput={(used) => set({ used })} />
      <Count label={words.checkout.lost} value={stated.lost} most={item.quantity} onInput={(lost) => set({ lost })} />
      {session.role === 'inspector' && stated.lost > 0 && (
        <label class="tick">
          <input type="checkbox" checked={stated.released} onChange={(event) => set({ released: event.currentTarget.checked })} />
          {words.checkout.release}
        </label>
      )}
      <label class="field">
        <span>
          {words.review.note}
          {stated.released && <em> {words.checkout.noteRequired}</em>}
        </span>
        <textarea rows={2} maxLength={1000} value={stated.note} required={stated.released} onInput={(event) => set({ note: event.currentTarget.value })} />
      </label>
      <div class="panel-pair">
        <button type="submit" class="primary" data-testid="item-state" disabled={!isPossible}>
          {words.checkout.state}
        </button>
        <button type="button" onClick={onLeave}>
          {words.page.cancel}
        </button>
      </div>
    </form>
  );
}
