// The steps of an inspection: what is done, what is next, and what prevents the next step.
import './inspection.css';
import { useState } from 'preact/hooks';
import { api } from '../link/api';
import { person } from '../link/client';
import { link } from '../link/live_link';
import { useStore } from '../store';
import type { Inspection, Session, SideName, Stage, TaskStatus } from '../types';
import { attempt, isBusy, lastFailure, openInspection } from './inspections';
import { BaselineCheckCard } from './BaselineCheckCard';
import { CaptureProgress, NoiseReport } from './CaptureProgress';
import { RegionsCard } from '../regions/RegionsCard';
import { ReadinessCard } from './ReadinessCard';
import { ViewsCard } from './ViewsCard';
import { timeOf } from './words';

const order: Stage[] = ['baseline', 'work', 'review', 'done'];
const labels: Record<Stage, string> = { baseline: 'Baseline', work: 'After the work', review: 'Review', done: 'Closed' };

export function StepBar({ stage }: { stage: Stage }) {
  const now = order.indexOf(stage);
  return (
    <ol class="steps" aria-label="Steps">
      {order.map((step, i) => (
        <li key={step} class={i < now ? 'past' : i === now ? 'now' : ''} aria-current={i === now ? 'step' : undefined}>
          <span class="step-number" aria-hidden="true">
            {i < now ? '✓' : i + 1}
          </span>
          {labels[step]}
          {i < now && <span class="unseen"> (done)</span>}
        </li>
      ))}
    </ol>
  );
}

function Failure({ inspection }: { inspection: Inspection }) {
  const failure = useStore(lastFailure);
  if (failure?.inspection !== inspection.id) return null;
  return (
    <p class="bad" role="alert" data-testid="failure">
      {failure.reason}
    </p>
  );
}

interface StepProps {
  inspection: Inspection;
  session: Session;
  task: TaskStatus;
}

function CaptureButton({ inspection, session, side, replaced, label }: Omit<StepProps, 'task'> & { side: SideName; replaced: boolean; label: string }) {
  const status = useStore(link.status);
  const lease = useStore(link.lease);
  const notReady = status?.readiness?.ready === false;
  const others = lease.holder !== undefined && !lease.yours;
  const why = session.role === 'viewer' ? 'You have view access only. An operator takes captures.' : others ? `${lease.holder} is driving. Ask them to hand back the controls.` : '';
  const take = () =>
    void attempt(() => api.capture(inspection.id, side, session.name || person.name || inspection.person, replaced));
  return (
    <>
      {notReady && <p class="bad">Not everything is ready: see above. You can capture anyway.</p>}
      {why && <p class="hint">{why}</p>}
      <button type="button" class="primary big" data-testid={`capture-${side}`} disabled={why !== '' || !status} onClick={take}>
        {label}
      </button>
    </>
  );
}

function BaselineStep({ inspection, session }: Omit<StepProps, 'task'>) {
  const mayCapture = session.role !== 'viewer';
  return (
    <>
      <div class="panel-body">
        <ViewsCard inspection={inspection} enabled={mayCapture} />
        <ReadinessCard mayCapture={mayCapture} />
      </div>
      <div class="panel-action">
        <Failure inspection={inspection} />
        <CaptureButton inspection={inspection} session={session} side="initial" replaced={false} label="Capture the baseline" />
      </div>
    </>
  );
}

function WorkStep({ inspection, session, task }: StepProps) {
  const simulation = useStore(link.status)?.simulation ?? false;
  const robot = useStore(link.status)?.robot !== undefined;
  const begun = inspection.final_begun;
  const [replaced, setReplaced] = useState(begun?.replaced ?? false);
  const [worked, setWorked] = useState(false);
  const simulate = () =>
    void attempt(async () => {
      await api.simulateWork(true);
      setWorked(true);
    });
  return (
    <>
      <div class="panel-body">
        <div class="card" data-testid="work">
          <h2>The baseline is saved</h2>
          <p>
            Taken {inspection.initial && timeOf(inspection.initial.taken_at)} by {inspection.initial?.person}. It survives a restart, a power cut and a change of shift: you can switch everything off.
          </p>
          <p>
            <strong>Now do the work in the bay.</strong> Come back here when it is done.
          </p>
          {inspection.final && <p>The captures after the work are saved, too: they can be compared without capturing again.</p>}
          {simulation && (
            <div class="note">
              <p>This bay is simulated: press the button to have the work done.</p>
              <button type="button" data-testid="simulate-work" onClick={simulate}>
                {worked ? '✓ Work has been done' : 'Simulate the work'}
              </button>
            </div>
          )}
        </div>
        <RegionsCard inspection={inspection} session={session} />
        <BaselineCheckCard inspection={inspection} task={task} />
        <ReadinessCard mayCapture={session.role !== 'viewer'} />
      </div>
      <div class="panel-action">
        {robot && (
          <label class="tick">
            <input type="checkbox" checked={replaced} onChange={(event) => setReplaced(event.currentTarget.checked)} />
            The robot was taken out and put back
          </label>
        )}
        {begun && (
          <p class="warn" role="status" data-testid="begins-anew">
            The capture after the work was interrupted. All views are captured again: somebody may have worked in the bay in the meantime.
          </p>
        )}
        <Failure inspection={inspection} />
        <div class="panel-pair">
          <div class="stack">
            <CaptureButton inspection={inspection} session={session} side="final" replaced={replaced} label="Capture and compare" />
          </div>
          {inspection.final && (
            <button type="button" data-testid="compare" disabled={session.role === 'viewer'} onClick={() => void attempt(() => api.compare(inspection.id))}>
              Compare what was captured
            </button>
          )}
        </div>
      </div>
    </>
  );
}

export function Steps({ session }: { session: Session }) {
  const inspection = useStore(openInspection);
  const task = useStore(link.status)?.task;
  if (!inspection || !task) return <p class="hint">Loading…</p>;
  const running = isBusy(task);
  if (running && task.inspection !== inspection.id) {
    return <p class="hint">Another inspection is being captured or compared.</p>;
  }
  if (running) {
    return (
      <div class="panel-body">
        <CaptureProgress task={task} mayCancel={session.role !== 'viewer'} />
        <NoiseReport task={task} />
      </div>
    );
  }
  return inspection.stage === 'baseline' ? (
    <BaselineStep inspection={inspection} session={session} />
  ) : (
    <WorkStep inspection={inspection} session={session} task={task} />
  );
}
