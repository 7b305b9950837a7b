// The steps of an inspection: what is done, what is next, and what prevents the next step.
import './inspection.css';
import { useState } from 'preact/hooks';
import { api } from '../link/api';
import { person } from '../link/client';
import { link } from '../link/live_link';
import { useStore } from '../store';
import type { Inspection, Session, SideName, Stage, TaskStatus } from '../types';
import { attempt, isBusy, openInspection } from './inspections';
import { CheckoutCard } from '../checkout/CheckoutCard';
import { BaselineCheckCard } from './BaselineCheckCard';
import { CaptureProgress, Failure, NoiseReport } from './CaptureProgress';
import { RegionsCard } from '../regions/RegionsCard';
import { ReadinessCard } from './ReadinessCard';
import { ViewsCard } from './ViewsCard';
import { timeOf } from './words';
import { Rich } from '../words/Rich';
import { words } from '../words/words';

const order: Stage[] = ['baseline', 'work', 'review', 'done'];

export function StepBar({ stage }: { stage: Stage }) {
  const now = order.indexOf(stage);
  return (
    <ol class="steps" aria-label={words.inspection.steps}>
      {order.map((step, i) => (
        <li key={step} class={i < now ? 'past' : i === now ? 'now' : ''} aria-current={i === now ? 'step' : undefined}>
          <span class="step-number" aria-hidden="true">
            {i < now ? '✓' : i + 1}
          </span>
          {words.inspection.stepNames[step]}
          {i < now && <span class="unseen"> {words.inspection.done}</span>}
        </li>
      ))}
    </ol>
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
  const why = session.role === 'viewer' ? words.inspection.viewer : others ? words.inspection.askToHandBack(lease.holder || words.page.somebody) : '';
  const take = () =>
    void attempt(() => api.capture(inspection.id, side, session.name || person.name || inspection.person, replaced));
  return (
    <>
      {notReady && <p class="bad">{words.inspection.notReadyAnyway}</p>}
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
        <CheckoutCard inspection={inspection} session={session} />
        <ReadinessCard mayCapture={mayCapture} />
      </div>
      <div class="panel-action">
        <Failure inspection={inspection} />
        <CaptureButton inspection={inspection} session={session} side="initial" replaced={false} label={words.inspection.captureBaseline} />
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
          <h2>{words.inspection.saved}</h2>
          <p>
            {inspection.initial && words.inspection.savedBy(timeOf(inspection.initial.taken_at), inspection.initial.person)}
          </p>
          <p>
            <Rich text={words.inspection.nowWork} />
          </p>
          {inspection.final && <p>{words.inspection.capturedToo}</p>}
          {simulation && (
            <div class="note">
              <p>{words.inspection.simulated}</p>
              <button type="button" data-testid="simulate-work" onClick={simulate}>
                {worked ? words.inspection.simulationDone : words.inspection.simulate}
              </button>
            </div>
          )}
        </div>
        <CheckoutCard inspection={inspection} session={session} />
        <RegionsCard inspection={inspection} session={session} />
        <BaselineCheckCard inspection={inspection} task={task} />
        <ReadinessCard mayCapture={session.role !== 'viewer'} />
      </div>
      <div class="panel-action">
        {robot && (
          <label class="tick">
            <input type="checkbox" checked={replaced} onChange={(event) => setReplaced(event.currentTarget.checked)} />
            {words.inspection.putBack}
          </label>
        )}
        {begun && (
          <p class="warn" role="status" data-testid="begins-anew">
            {words.inspection.begunAnew}
          </p>
        )}
        <Failure inspection={inspection} />
        <div class="panel-pair">
          <div class="stack">
            <CaptureButton inspection={inspection} session={session} side="final" replaced={replaced} label={words.inspection.captureAndCompare} />
          </div>
          {inspection.final && (
            <button type="button" data-testid="compare" disabled={session.role === 'viewer'} onClick={() => void attempt(() => api.compare(inspection.id))}>
              {words.inspection.compareCaptured}
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
  if (!inspection || !task) return <p class="hint">{words.page.loading}</p>;
  const running = isBusy(task);
  if (running && task.inspection !== inspection.id) {
    return <p class="hint">{words.inspection.anotherBusy}</p>;
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
