// The list of inspections, and the form for a new one.
import { useEffect, useState } from 'preact/hooks';
import { api } from '../link/api';
import { person } from '../link/client';
import { link } from '../link/live_link';
import { useStore } from '../store';
import type { Session } from '../types';
import { attempt, inspectionList, loadList, open } from './inspections';
import { stageNames, timeOf, titleOf } from './words';

const empty = { aircraft: '', zone: '', work_order: '' };

function Field({ label, value, required, onInput }: { label: string; value: string; required?: boolean; onInput: (value: string) => void }) {
  return (
    <label class="field">
      <span>
        {label}
        {required && <em> (required)</em>}
      </span>
      <input value={value} maxLength={100} required={required ?? false} onInput={(event) => onInput(event.currentTarget.value)} />
    </label>
  );
}

function NewInspection({ session }: { session: Session }) {
  const [order, setOrder] = useState(empty);
  const signedIn = session.name ?? '';
  const [name, setName] = useState(signedIn || person.name);
  const begin = (event: Event) => {
    event.preventDefault();
    person.name = name.trim();
    void attempt(async () => {
      if (link.status.value?.simulation) await api.simulateWork(false);
      await open((await api.begin({ ...order, person: name.trim() })).id);
    });
  };
  const set = (key: keyof typeof empty) => (value: string) => setOrder({ ...order, [key]: value });
  return (
    <form class="card" onSubmit={begin} aria-label="New inspection">
      <h2>New inspection</h2>
      <Field label="Aircraft" value={order.aircraft} required onInput={set('aircraft')} />
      <Field label="Zone" value={order.zone} required onInput={set('zone')} />
      <Field label="Work order" value={order.work_order} onInput={set('work_order')} />
      {signedIn === '' && <Field label="Your name" value={name} required onInput={setName} />}
      <button type="submit" class="primary" data-testid="begin" disabled={[order.aircraft, order.zone, name].some((text) => text.trim() === '') || session.role === 'viewer'}>
        Begin
      </button>
    </form>
  );
}

export function Begin({ session }: { session: Session }) {
  const list = useStore(inspectionList);
  useEffect(() => void loadList().catch(() => undefined), []);
  return (
    <div class="panel-body">
      <NewInspection session={session} />
      <div class="card" aria-label="Inspections" role="region">
        <h2>Earlier inspections</h2>
        {list === null && <p class="hint">Loading…</p>}
        {list?.length === 0 && <p class="hint">No inspection yet.</p>}
        <ul class="list">
          {list?.map((inspection) => (
            <li key={inspection.id}>
              <button type="button" class="row" data-testid={`open-${inspection.id}`} onClick={() => void attempt(() => open(inspection.id))}>
                <strong>{titleOf(inspection)}</strong>
                <span>
                  {stageNames[inspection.stage]}
                  {inspection.undecided_count > 0 && ` · ${inspection.undecided_count} to decide`}
                </span>
                <small>
                  {inspection.person}, {timeOf(inspection.created_at)}
                </small>
              </button>
            </li>
          ))}
        </ul>
      </div>
    </div>
  );
}
