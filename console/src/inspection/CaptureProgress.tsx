// A capture or a comparison under way, and what it would find.
import { useState } from 'preact/hooks';
import { api } from '../link/api';
import { useStore } from '../store';
import type { Inspection, Levels, TaskStatus } from '../types';
import { attempt, lastFailure } from './inspections';
import { findableText, millimetres, objectWidth_mm } from './words';
import { Rich } from '../words/Rich';
import { decimal, percentText, sentence, words } from '../words/words';

function doneShare(task: TaskStatus): number {
  if (task.kind === 'capture') {
    const captures = task.views * task.captures;
    const taken = task.view * task.captures + task.capture + (task.frames === 0 ? 0 : task.frame / task.frames);
    return captures === 0 ? 0 : taken / captures;
  }
  return task.total === 0 ? 0 : task.done / task.total;
}

function description(task: TaskStatus): string {
  const { capture, comparingNow, frames, turning, turningCloser, viewOf, waiting } = words.inspection;
  if (task.waiting) return waiting(task.waiting);
  if (task.kind === 'comparison') return comparingNow;
  if (task.kind === 'signing') return words.inspection.copyingFiles;
  const view = task.views > 1 ? `${viewOf(task.view + 1, task.views)}, ` : '';
  const number = task.captures > 1 ? `${capture(task.capture + 1, task.captures)}: ` : '';
  const turn = task.approach === 0 ? turning : turningCloser(task.approach + 1, task.approaches);
  return sentence(`${view}${number}${task.frame === 0 ? turn : frames(task.frame, task.frames)}`);
}

/** The least height of an object that would be found, by distance, and the width that it must have. */
export function FindableTable({ levels, caption }: { levels: Levels; caption: string }) {
  const sure_mm = 100;
  const rows = levels.by_distance.filter((level) => level.median_mm < sure_mm);
  const hasWidths = rows.every((level) => level.width_mm !== undefined);
  return (
    <table class="findable">
      <caption>
        {caption}
        {hasWidths && <small>{words.inspection.widthHelp}</small>}
      </caption>
      <thead>
        <tr>
          <th scope="col">{words.inspection.distance}</th>
          <th scope="col">{words.inspection.betterHalf}</th>
          <th scope="col">{words.inspection.nearlyEverywhere}</th>
          {hasWidths && <th scope="col">{words.inspection.width}</th>}
        </tr>
      </thead>
      <tbody>
        {rows.map((level) => (
          <tr key={level.from_m}>
            <th scope="row">
              {decimal(level.from_m, 1)}–{decimal(level.to_m, 1)} m
            </th>
            <td>{millimetres(level.median_mm)}</td>
            <td>{millimetres(level.p90_mm)}</td>
            {hasWidths && <td>{millimetres(objectWidth_mm(levels, level) ?? 0)}</td>}
          </tr>
        ))}
      </tbody>
    </table>
  );
}

/** Captures of a view from which on a baseline is compared with itself. */
const least_to_check = 4;

export function NoiseReport({ task }: { task: TaskStatus }) {
  const [shown, setShown] = useState(false);
  const noise = task.noise;
  if (!noise) return null;
  const measures = words.inspection.measures(percentText(noise.measured), `${decimal(noise.median_std_mm, 2)} mm`);
  // A robot does not return exactly, so that less would be found than these frames show.
  if (task.captures > 1) {
    return (
      <div class="card" data-testid="noise">
        <h2>{words.inspection.whatIsMeasured}</h2>
        <p>
          <Rich text={measures} />
        </p>
        <p class="hint">{task.captures < least_to_check ? words.inspection.knownAfterwards : words.inspection.knownWithBaseline}</p>
      </div>
    );
  }
  const shares = sentence(findableText(noise.findable.findable ?? [], 'atBest'));
  return (
    <div class="card" data-testid="noise">
      <h2>{words.inspection.howSmall}</h2>
      <p>
        <Rich text={measures} />
      </p>
      {shares && <p>{shares}.</p>}
      <FindableTable levels={noise.findable} caption={words.inspection.bestHeight} />
      <p class="hint">{words.inspection.afterwards}</p>
      <button type="button" aria-expanded={shown} onClick={() => setShown(!shown)}>
        {shown ? words.inspection.hidePicture : words.inspection.showPicture}
      </button>
      {shown && <img class="wide" src={`/api/findable.png?${task.number}-${task.view}-${task.capture}-${noise.frames}`} alt={words.inspection.findablePicture} />}
    </div>
  );
}

/** Why the last task of an inspection failed or was cancelled. */
export function Failure({ inspection }: { inspection: Inspection }) {
  const failure = useStore(lastFailure);
  if (failure?.inspection !== inspection.id) return null;
  return (
    <p class="bad" role="alert" data-testid="failure">
      {failure.reason}
    </p>
  );
}

function title(task: TaskStatus): string {
  if (task.kind === 'comparison') return words.inspection.comparing;
  if (task.kind === 'signing') return words.inspection.signing;
  return words.inspection.capturing[task.side === 'initial' ? 'initial' : 'final'];
}

export function CaptureProgress({ task, mayCancel }: { task: TaskStatus; mayCancel: boolean }) {
  const share = doneShare(task);
  return (
    <div class="card" data-testid="progress">
      <h2>{title(task)}</h2>
      <div class="progress" role="progressbar" aria-valuemin={0} aria-valuemax={100} aria-valuenow={Math.round(100 * share)} aria-label={words.inspection.progress}>
        <span style={{ width: `${100 * share}%` }} />
      </div>
      <p role="status" class={task.waiting ? 'bad' : ''}>
        {description(task)}
      </p>
      {task.kind !== 'signing' && <p class="hint">{words.inspection.keepStill}</p>}
      <button type="button" data-testid="cancel" disabled={!mayCancel} onClick={() => void attempt(() => api.cancel())}>
        {words.page.cancel}
      </button>
    </div>
  );
}
