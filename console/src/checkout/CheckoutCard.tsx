// The check-out list: tools and parts that were taken into the bay, and what became of each.
import './checkout.css';
import { useState } from 'preact/hooks';
import { attempt, update } from '../inspection/inspections';
import { api } from '../link/api';
import { person } from '../link/client';
import type { Inspection, Item, ItemRequest, Session } from '../types';
import { words } from '../words/words';
import { AddItems } from './AddItems';
import { ItemForm } from './ItemForm';
import { unaccounted } from './items';

function title({ name, identity, quantity }: Item): string {
  return `${name}${identity && ` ${identity}`}${quantity > 1 ? ` × ${quantity}` : ''}`;
}

function Row({ item, inspection, session, onState }: { item: Item; inspection: Inspection; session: Session; onState: (item: Item, statement: Omit<ItemRequest, 'person'>) => void }) {
  const [open, setOpen] = useState(false);
  const mayState = session.role !== 'viewer' && !inspection.closing;
  const last = item.statements.at(-1);
  return (
    <li class={`item ${item.state}`} data-testid={`item-${item.number}`}>
      <div class="item-line">
        <span>
          <strong>{title(item)}</strong>
          <small>
            {words.checkout.states[item.state]}
            {last && (item.quantity > 1 || last.lost > 0) && ` (${words.checkout.counts(last.returned, last.used, last.lost)})`}
            {last?.note && `: ${last.note}`}
          </small>
        </span>
        {mayState && item.state === 'out' && !open && (
          <button type="button" data-testid={`item-back-${item.number}`} onClick={() => onState(item, { returned: item.quantity, used: 0, lost: 0, released: false, note: '' })}>
            {words.checkout.back}
          </button>
        )}
        {mayState && !open && (
          <button type="button" aria-label={words.checkout.whatBecameOf(item.name)} onClick={() => setOpen(true)}>
            …
          </button>
        )}
      </div>
      {open && (
        <ItemForm
          item={item}
          session={session}
          onLeave={() => setOpen(false)}
          onState={(statement) => {
            setOpen(false);
            onState(item, statement);
          }}
        />
      )}
    </li>
  );
}

export function CheckoutCard({ inspection, session }: { inspection: Inspection; session: Session }) {
  const { items } = inspection;
  const open = unaccounted(inspection).length;
  const mayChange = session.role !== 'viewer' && !inspection.closing;
  const name = session.name || person.name || inspection.person;
  const add = (csv: string) => attempt(async () => update(await api.checkOut(inspection.id, csv.replaceAll('\r\n', '\n'), name)));
  const state = (item: Item, statement: Omit<ItemRequest, 'person'>) =>
    void attempt(async () => update(await api.stateItem(inspection.id, item.number, { ...statement, person: name })));
  if (items.length === 0 && !mayChange) return null;
  return (
    <details class="card checkout" data-testid="checkout">
      <summary>
        <h2>{words.checkout.title}</h2>
        <span class={open > 0 ? 'open' : items.length > 0 ? 'good' : ''}>{items.length === 0 ? words.checkout.none : words.checkout.accountedFor(items.length - open, items.length)}</span>
      </summary>
      <ul class="list">
        {items.map((item) => (
          <Row key={item.number} item={item} inspection={inspection} session={session} onState={state} />
        ))}
      </ul>
      {mayChange && <AddItems onAdd={add} />}
    </details>
  );
}
