// The list of inspections, and the form for a new one.
import { useEffect, useState } from 'preact/hooks';
import { api } from '../link/api';
import { person } from '../link/client';
import { link } from '../link/live_link';
import { useStore } from '../store';
import { trendsShown } from '../trends/trends';
import type { InspectionSummary, Session, Stage } from '../types';
import { attempt, hasMore, inspectionList, listFilter, loadList, open, wholeList, type ListFilter } from './inspections';
import { timeOf, titleOf } from './words';
import { words } from '../words/words';

const stages: Stage[] = ['baseline', 'work', 'review', 'done'];

const empty = { aircraft: '', zone: '', work_order: '' };

function Field({ label, value, required, onInput }: { label: string; value: string; required?: boolean; onInput: (value: string) => void }) {
  return (
    <label class="field">
      <span>
        {label}
        {required && <em> {words.page.required}</em>}
      </span>
      <input value={value} maxLength={100} required={required ?? false} enterkeyhint="next" onInput={(event) => onInput(event.currentTarget.value)} />
    </label>
  );
}

// The keyboard's key for the next field goes on to what is required and missing, so that nobody needs to tap it.
function goOn(event: KeyboardEvent): void {
  if (event.key !== 'Enter' || !(event.target instanceof HTMLInputElement)) return;
  const missing = [...(event.target.form?.querySelectorAll('input') ?? [])].find((input) => input.required && input.value.trim() === '');
  if (!missing) return;
  event.preventDefault();
  missing.focus();
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
    <form class="card" onSubmit={begin} onKeyDown={goOn} aria-label={words.inspection.newInspection}>
      <h2>{words.inspection.newInspection}</h2>
      <Field label={words.inspection.aircraft} value={order.aircraft} required onInput={set('aircraft')} />
      <Field label={words.inspection.zone} value={order.zone} required onInput={set('zone')} />
      <Field label={words.inspection.workOrder} value={order.work_order} onInput={set('work_order')} />
      {signedIn === '' && <Field label={words.page.yourName} value={name} required onInput={setName} />}
      <button type="submit" class="primary" data-testid="begin" disabled={[order.aircraft, order.zone, name].some((text) => text.trim() === '') || session.role === 'viewer'}>
        {words.inspection.begin}
      </button>
    </form>
  );
}

function Search() {
  const filter = useStore(listFilter);
  const set = (change: Partial<ListFilter>) => {
    listFilter.value = { ...filter, ...change };
    void attempt(() => loadList());
  };
  return (
    <form class="search" role="search" aria-label={words.inspection.inspections} onSubmit={(event) => event.preventDefault()}>
      <label class="field">
        <span>{words.inspection.search}</span>
        <input type="search" placeholder={words.inspection.searchHelp} value={filter.text} maxLength={100} data-testid="search" onInput={(event) => set({ text: event.currentTarget.value })} />
      </label>
      <details open={filter.stage !== '' || filter.from !== '' || filter.until !== ''}>
        <summary>{words.inspection.byStepAndDate}</summary>
        <label class="field">
          <span>{words.inspection.step}</span>
          <select value={filter.stage} data-testid="search-stage" onChange={(event) => set({ stage: event.currentTarget.value as ListFilter['stage'] })}>
            <option value="">{words.inspection.any}</option>
            {stages.map((stage) => (
              <option key={stage} value={stage}>
                {words.inspection.stages[stage]}
              </option>
            ))}
          </select>
        </label>
        <div class="panel-pair">
          <label class="field">
            <span>{words.inspection.from}</span>
            <input type="date" value={filter.from} onChange={(event) => set({ from: event.currentTarget.value })} />
          </label>
          <label class="field">
            <span>{words.inspection.until}</span>
            <input type="date" value={filter.until} onChange={(event) => set({ until: event.currentTarget.value })} />
          </label>
        </div>
      </details>
    </form>
  );
}

function Entry({ inspection, mayDelete }: { inspection: InspectionSummary; mayDelete: boolean }) {
  const remove = () =>
    void attempt(async () => {
      await api.remove(inspection.id);
      await loadList();
    });
  return (
    <li class="entry">
      <button type="button" class="row" data-testid={`open-${inspection.id}`} onClick={() => void attempt(() => open(inspection.id))}>
        <strong>{titleOf(inspection)}</strong>
        <span>
          {inspection.has_signature ? words.inspection.signedStage : words.inspection.stages[inspection.stage]}
          {inspection.undecided_count > 0 && ` · ${words.inspection.toDecide(inspection.undecided_count)}`}
        </span>
        <small>
          {inspection.person}, {timeOf(inspection.created_at)}
        </small>
      </button>
      {mayDelete && inspection.stage === 'baseline' && inspection.findings_count === 0 && (
        <button type="button" aria-label={words.inspection.deleteEmpty(inspection.id)} data-testid={`delete-${inspection.id}`} onClick={remove}>
          ✕
        </button>
      )}
    </li>
  );
}

export function Begin({ session }: { session: Session }) {
  const list = useStore(inspectionList);
  const more = useStore(hasMore);
  const trends = useStore(trendsShown);
  const filtered = useStore(listFilter) !== wholeList;
  useEffect(() => void loadList().catch(() => undefined), []);
  return (
    <div class="panel-body">
      <NewInspection session={session} />
      <div class="card" aria-label={words.inspection.inspections} role="region">
        <div class="card-head">
          <h2>{words.inspection.earlier}</h2>
          <button type="button" aria-pressed={trends} data-testid="trends-open" onClick={() => (trendsShown.value = !trends)}>
            {words.trends.title}
          </button>
        </div>
        <Search />
        {list === null && <p class="hint">{words.page.loading}</p>}
        {list?.length === 0 && <p class="hint">{filtered ? words.inspection.noneMatches : words.inspection.none}</p>}
        <ul class="list">
          {list?.map((inspection) => (
            <Entry key={inspection.id} inspection={inspection} mayDelete={session.role !== 'viewer'} />
          ))}
        </ul>
        {more && (
          <button type="button" data-testid="more" onClick={() => void attempt(() => loadList(true))}>
            {words.inspection.more}
          </button>
        )}
      </div>
    </div>
  );
}
