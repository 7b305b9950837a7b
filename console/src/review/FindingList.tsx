// Findings, most suspicious first, each to be decided.
import './review.css';
import { link } from '../link/live_link';
import { api } from '../link/api';
import { person } from '../link/client';
import { attempt } from '../inspection/inspections';
import { percent } from '../regions/region_words';
import { signOf, suspicion, verdictNames, whatChanged, whereAndHow } from '../inspection/words';
import { useStore } from '../store';
import type { Decision, Inspection, Session } from '../types';
import { DecisionForm } from './DecisionForm';
import { decisionOf, groupsOf, type Group } from './groups';
import { Moved } from './Moved';
import { review, show } from './review_state';

function SuspicionBar({ level, name }: { level: number; name: string }) {
  return (
    <span class="suspicion">
      <span aria-hidden="true">{'●'.repeat(level) + '○'.repeat(3 - level)}</span> {name}
    </span>
  );
}

function DecisionText({ decision }: { decision: Decision | undefined }) {
  if (!decision) return <small class="open">To be decided</small>;
  const settled = decision.verdict !== 'second-look';
  return (
    <small class={settled ? 'said' : 'open'}>
      {settled ? '✓' : '…'} {verdictNames[decision.verdict]}
      {decision.note && <q>{decision.note}</q>}
    </small>
  );
}

function FindingCard({ inspection, groups, group, session, selected }: { inspection: Inspection; groups: Group[]; group: Group; session: Session; selected: boolean }) {
  const { lead, all } = group;
  const decision = decisionOf(group);
  const { level, name } = suspicion(lead);
  return (
    <li class={`finding ${selected ? 'selected' : ''} ${decision ? 'decided' : ''}`} data-testid={`finding-${lead.number}`}>
      <button type="button" class="row" aria-expanded={selected} onClick={() => show({ group: lead.number, view: lead.view, findings: true })}>
        <span class={`finding-number ${lead.kind}`}>
          {group.label}
          <span aria-hidden="true">{signOf(lead.kind)}</span>
        </span>
        <span>
          <strong>{whatChanged(lead)}</strong>
          <SuspicionBar level={level} name={name} />
          <small>
            {whereAndHow(lead)}
            {all.length > 1 && `, seen in ${all.length} views`}
          </small>
          <DecisionText decision={decision} />
        </span>
      </button>
      <Moved groups={groups} group={group} />
      {selected && <DecisionForm inspection={inspection} group={group} session={session} />}
    </li>
  );
}

// That nothing was found means nothing for what could not be inspected.
function Extent({ inspection, nothing }: { inspection: Inspection; nothing: boolean }) {
  const half = 0.5;
  const least = [...inspection.compared].sort((one, other) => one.judged - other.judged)[0];
  if (!least) return null;
  const { judged, coverage } = least;
  const left_out = coverage.left_out ?? 0;
  const few = judged < half;
  const blind = judged < half * (1 - left_out);
  if (!nothing && !few) return null;
  return (
    <p class={few ? 'bad' : ''} data-testid="extent">
      {few ? '✗ ' : ''}
      {nothing ? 'Nothing was found in what could be inspected: ' : 'Inspected: '}
      <strong>{Math.round(100 * judged)} %</strong> of the {inspection.compared.length > 1 ? 'view with the least coverage' : 'view'}
      {left_out > 0 && `; ${percent(left_out)} was left out as asked`}.{' '}
      {blind ? 'Most of it could not be inspected, so this result means little. Check the camera and its view, and capture again.' : 'Inspect the rest (striped) by eye.'}
    </p>
  );
}

// The next step after the decisions. Debris that was removed counts as gone only when a new capture shows it.
function Verdicts({ groups, inspection, session }: { groups: Group[]; inspection: Inspection; session: Session }) {
  const simulation = useStore(link.status)?.simulation ?? false;
  const count = (verdict: string) => groups.filter((group) => decisionOf(group)?.verdict === verdict).length;
  const [unsettled, removed] = [count('second-look'), count('debris-removed')];
  const again = () =>
    void attempt(async () => {
      if (simulation) await api.simulateWork(false);
      await api.capture(inspection.id, 'final', session.name || person.name || inspection.person, false);
    });
  if (unsettled > 0) {
    return (
      <p class="open" data-testid="all-decided">
        … {unsettled === 1 ? 'One needs' : `${unsettled} need`} a second look. Look again, also in the bay, then decide again: this inspection is not done.
      </p>
    );
  }
  if (removed === 0) {
    return (
      <p class="good" data-testid="all-decided">
        ✓ All findings are decided. This inspection is done.
      </p>
    );
  }
  return (
    <>
      <p data-testid="all-decided">
        <span class="good">✓ All findings are decided.</span> Debris was removed since these pictures were taken: capture again to see that it is gone, and that nothing else was left.
      </p>
      <button type="button" class="primary" data-testid="capture-again" disabled={session.role === 'viewer'} onClick={again}>
        Capture again{simulation ? ' (the simulated bay is tidied up)' : ''}
      </button>
    </>
  );
}

export function FindingList({ inspection, session }: { inspection: Inspection; session: Session }) {
  const state = useStore(review);
  const groups = groupsOf(inspection);
  const open = groups.filter((group) => !decisionOf(group)).length;
  if (!state.findings && state.group === 0) {
    return (
      <div class="panel-body">
        <div class="card" data-testid="first-look">
          <h2>First look</h2>
          <p>First compare before and after by eye: blink between them. Then let the program show its findings.</p>
          <button type="button" class="primary big" data-testid="reveal" onClick={() => show({ findings: true, uninspected: true, group: groups[0]?.lead.number ?? 0, view: groups[0]?.lead.view ?? 0 })}>
            Show the findings
          </button>
        </div>
      </div>
    );
  }
  return (
    <div class="panel-body">
      <div class="card" data-testid="finding-summary">
        <h2>{groups.length === 0 ? 'Nothing found' : groups.length === 1 ? '1 finding' : `${groups.length} findings`}</h2>
        <Extent inspection={inspection} nothing={groups.length === 0} />
        {open > 0 && <p>{open} to be decided.</p>}
        {open === 0 && groups.length > 0 && <Verdicts groups={groups} inspection={inspection} session={session} />}
      </div>
      <ul class="list">
        {groups.map((group) => (
          <FindingCard key={group.lead.number} inspection={inspection} groups={groups} group={group} session={session} selected={group.lead.number === state.group} />
        ))}
      </ul>
    </div>
  );
}
