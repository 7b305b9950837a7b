// A capture or a comparison under way, and what it would find.
import { useState } from 'preact/hooks';
import { api } from '../link/api';
import type { Levels, TaskStatus } from '../types';
import { attempt } from './inspections';
import { hiddenByDepth_px, millimetres } from './words';

function doneShare(task: TaskStatus): number {
  if (task.kind === 'capture') {
    const captures = task.views * task.captures;
    const taken = task.view * task.captures + task.capture + (task.frames === 0 ? 0 : task.frame / task.frames);
    return captures === 0 ? 0 : taken / captures;
  }
  return task.total === 0 ? 0 : task.done / task.total;
}

function description(task: TaskStatus): string {
  if (task.waiting) return `Waiting: ${task.waiting}`;
  if (task.kind === 'comparison') return 'Comparing before and after…';
  const view = task.views > 1 ? `View ${task.view + 1} of ${task.views}, ` : '';
  const capture = task.captures > 1 ? `capture ${task.capture + 1} of ${task.captures}: ` : '';
  const turning = task.approach === 0 ? 'turning the camera' : `turning the camera closer to the baseline (approach ${task.approach + 1} of up to ${task.approaches})`;
  const doing = task.frame === 0 ? turning : `${task.frame} of ${task.frames} frames`;
  const text = `${view}${capture}${doing}`;
  return text.charAt(0).toUpperCase() + text.slice(1);
}

/** The least height of an object that would be found, by distance. */
export function FindableTable({ levels, caption }: { levels: Levels; caption: string }) {
  const sure_mm = 100;
  const rows = levels.by_distance.filter((level) => level.median_mm < sure_mm);
  return (
    <table class="findable">
      <caption>{caption}</caption>
      <thead>
        <tr>
          <th scope="col">Distance</th>
          <th scope="col">in the better half</th>
          <th scope="col">nearly everywhere</th>
        </tr>
      </thead>
      <tbody>
        {rows.map((level) => (
          <tr key={level.from_m}>
            <th scope="row">
              {level.from_m.toFixed(1)}–{level.to_m.toFixed(1)} m
            </th>
            <td>{millimetres(level.median_mm)}</td>
            <td>{millimetres(level.p90_mm)}</td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}

export function NoiseReport({ task }: { task: TaskStatus }) {
  const [shown, setShown] = useState(false);
  const noise = task.noise;
  if (!noise) return null;
  return (
    <div class="card" data-testid="noise">
      <h2>How small an object would be found here</h2>
      <p>
        The camera measures <strong>{Math.round(100 * noise.measured)} %</strong> of this view; depth noise:{' '}
        <strong>{noise.median_std_mm.toFixed(2)} mm</strong>.
      </p>
      <FindableTable levels={noise.findable} caption="Height from which an object would be found, at best" />
      <p class="hint">For an object {noise.findable.window_px + hiddenByDepth_px} pixels wide. After the final capture you see what was really possible.</p>
      <button type="button" aria-expanded={shown} onClick={() => setShown(!shown)}>
        {shown ? 'Hide the picture' : 'Show it as a picture'}
      </button>
      {shown && <img class="wide" src={`/api/findable.png?${task.number}-${task.view}-${task.capture}-${noise.frames}`} alt="Smallest height that would be found at each pixel; blue is small, red large, black cannot be judged" />}
    </div>
  );
}

export function CaptureProgress({ task, mayCancel }: { task: TaskStatus; mayCancel: boolean }) {
  const share = doneShare(task);
  return (
    <div class="card" data-testid="progress">
      <h2>{task.kind === 'comparison' ? 'Comparing' : task.side === 'initial' ? 'Capturing the baseline' : 'Capturing after the work'}</h2>
      <div class="progress" role="progressbar" aria-valuemin={0} aria-valuemax={100} aria-valuenow={Math.round(100 * share)} aria-label="Progress">
        <span style={{ width: `${100 * share}%` }} />
      </div>
      <p role="status" class={task.waiting ? 'bad' : ''}>
        {description(task)}
      </p>
      <p class="hint">Keep hands and hoses still.</p>
      <button type="button" data-testid="cancel" disabled={!mayCancel} onClick={() => void attempt(() => api.cancel())}>
        Cancel
      </button>
    </div>
  );
}
