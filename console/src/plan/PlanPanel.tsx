// What the work order states will change in a view: its parts, as they were drawn or loaded from a plan file.
import { useRef } from 'preact/hooks';
import { isBusy } from '../inspection/inspections';
import { millimetres } from '../inspection/words';
import { link } from '../link/live_link';
import { useStore } from '../store';
import type { Inspection, PlanPart, Session } from '../types';
import { words } from '../words/words';
import { PartForm } from './PartForm';
import { planOf, planState, removePart, savePlan } from './plan_state';

function partText(part: PlanPart): string {
  const height = part.height_mm && words.plan.height(millimetres(part.height_mm[0]), millimetres(part.height_mm[1]));
  return [words.plan.kinds[part.kind], ...(height ? [height] : []), ...(part.places ? [words.plan.withPlaces] : [])].join(', ');
}

function PartList({ inspection, view, mayChange }: { inspection: Inspection; view: number; mayChange: boolean }) {
  const plan = planOf(inspection, view);
  return (
    <div class="card" data-testid="plan-parts">
      <h2>{words.page.view(view + 1)}</h2>
      {!plan && <p class="hint">{words.plan.none}</p>}
      {plan?.coordinates === 'metres' && <p class="hint">{words.plan.inMetres}</p>}
      <ul class="list">
        {plan?.parts.map((part) => (
          <li key={part.name} class="view-row">
            <span class="wide">
              <strong>{words.plan.counted(part.count, part.name)}</strong>
              <small>{partText(part)}</small>
            </span>
            <button type="button" aria-label={words.plan.removeIt(part.name)} disabled={!mayChange} data-testid={`plan-remove-${part.name}`} onClick={() => void removePart(inspection, view, part.name)}>
              ✕
            </button>
          </li>
        ))}
      </ul>
    </div>
  );
}

function LoadFile({ inspection, view, enabled }: { inspection: Inspection; view: number; enabled: boolean }) {
  const input = useRef<HTMLInputElement>(null);
  const load = async (file: File | undefined) => {
    if (file) await savePlan(inspection, view, await file.text());
    if (input.current) input.current.value = '';
  };
  return (
    <>
      <input ref={input} type="file" accept=".yaml,.yml,.json" hidden aria-label={words.plan.load} data-testid="plan-file" onChange={(event) => void load(event.currentTarget.files?.[0])} />
      <button type="button" disabled={!enabled} data-testid="plan-load" onClick={() => input.current?.click()}>
        {planOf(inspection, view) ? words.plan.loadInstead : words.plan.load}
      </button>
    </>
  );
}

export function PlanPanel({ inspection, session }: { inspection: Inspection; session: Session }) {
  const state = useStore(planState);
  const busy = isBusy(useStore(link.status)?.task);
  const view = Math.min(state.view, inspection.views.length - 1);
  const mayChange = session.role !== 'viewer' && !busy && !inspection.closing;
  return (
    <>
      {/* It may scroll while nothing in it can be focused. */}
      <div class="panel-body" tabIndex={0}>
        <div class="card" data-testid="plan-panel">
          <h2>{words.plan.title}</h2>
          <p>{words.plan.purpose}</p>
          {session.role === 'viewer' && <p class="hint">{words.plan.viewer}</p>}
          {inspection.compared_at && !inspection.closing && <p class="warn">{words.plan.compared}</p>}
        </div>
        <PartList inspection={inspection} view={view} mayChange={mayChange} />
      </div>
      {mayChange && state.drawn ? (
        <PartForm inspection={inspection} view={view} drawn={state.drawn} />
      ) : (
        mayChange && (
          <div class="panel-action">
            <LoadFile inspection={inspection} view={view} enabled={mayChange} />
          </div>
        )
      )}
    </>
  );
}
