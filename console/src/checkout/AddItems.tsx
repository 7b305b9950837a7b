// Adds lines to the check-out list, one at a time or from a CSV file of the tool crib.
import { useRef, useState } from 'preact/hooks';
import { words } from '../words/words';
import { lineOf } from './items';

const most_quantity = 100_000;

/** @param onAdd is called with CSV and resolves to whether it was accepted */
export function AddItems({ onAdd }: { onAdd: (csv: string) => Promise<boolean> }) {
  const file = useRef<HTMLInputElement>(null);
  const [name, setName] = useState('');
  const [identity, setIdentity] = useState('');
  const [quantity, setQuantity] = useState(1);
  const add = (event: Event) => {
    event.preventDefault();
    void onAdd(lineOf(name.trim(), identity.trim(), quantity)).then((added) => {
      if (!added) return;
      setName('');
      setIdentity('');
      setQuantity(1);
    });
  };
  const load = async (chosen: File | undefined) => {
    if (chosen) await onAdd(await chosen.text());
    if (file.current) file.current.value = '';
  };
  return (
    <form class="stack" onSubmit={add} aria-label={words.checkout.add} data-testid="add-item">
      <label class="field">
        <span>{words.checkout.item}</span>
        <input value={name} maxLength={100} required onInput={(event) => setName(event.currentTarget.value)} />
      </label>
      <div class="panel-pair">
        <label class="field">
          <span>{words.checkout.identity}</span>
          <input value={identity} maxLength={100} onInput={(event) => setIdentity(event.currentTarget.value)} />
        </label>
        <label class="field">
          <span>{words.checkout.quantity}</span>
          <input type="number" inputMode="numeric" min={1} max={most_quantity} required value={quantity} onInput={(event) => setQuantity(event.currentTarget.valueAsNumber || 0)} />
        </label>
      </div>
      <div class="panel-pair">
        <button type="submit" data-testid="add-item-confirm" disabled={name.trim() === '' || quantity < 1}>
          {words.checkout.add}
        </button>
        <input ref={file} type="file" accept=".csv,text/csv" hidden aria-label={words.checkout.load} data-testid="items-file" onChange={(event) => void load(event.currentTarget.files?.[0])} />
        <button type="button" onClick={() => file.current?.click()}>
          {words.checkout.load}
        </button>
      </div>
    </form>
  );
}
