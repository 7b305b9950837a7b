// What could be found after the work, as determined by comparing the baseline with itself.
import { useEffect, useState } from 'preact/hooks';
import { api, baselineAddress } from '../link/api';
import type { BaselineCheck, Inspection, Levels, TaskStatus } from '../types';
import { FindableTable, NoiseReport } from './CaptureProgress';
import { findableText, leastFindable } from './words';
import { words } from '../words/words';

/** The largest levels that any view has at each distance. */
function worstOf(levels: Levels[]): Levels | null {
  const [first, ...others] = levels;
  if (!first) return null;
  const rows = new Map(first.by_distance.map((row) => [row.from_m, row]));
  for (const row of others.flatMap((other) => other.by_distance)) {
    const known = rows.get(row.from_m);
    rows.set(row.from_m, {
      ...row,
      median_mm: Math.max(row.median_mm, known?.median_mm ?? 0),
      p90_mm: Math.max(row.p90_mm, known?.p90_mm ?? 0),
      ...(row.width_mm !== undefined && { width_mm: Math.max(row.width_mm, known?.width_mm ?? 0) }),
    });
  }
  return { ...first, by_distance: [...rows.values()].sort((a, b) => a.from_m - b.from_m) };
}

function noteOf(view: BaselineCheck['views'][number]): string | null {
  const name = words.page.view(view.view + 1);
  if (view.problem) return words.inspection.uncheckable(name, view.problem);
  const count = view.false_findings ?? 0;
  if (count === 0) return null;
  return words.inspection.falseFindings(name, count);
}

function CheckPicture({ inspection, check }: { inspection: Inspection; check: BaselineCheck }) {
  const [shown, setShown] = useState<number | null>(null);
  const views = check.views.filter((view) => view.level_of_detection);
  const current = views.find((view) => view.view === shown);
  return (
    <>
      <div class="panel-pair">
        {views.map((view) => (
          <button key={view.view} type="button" aria-pressed={shown === view.view} onClick={() => setShown(shown === view.view ? null : view.view)}>
            {views.length > 1 ? words.inspection.pictureOfView(view.view + 1) : words.inspection.showPicture}
          </button>
        ))}
      </div>
      {current && (
        <img
          class="wide"
          src={baselineAddress(inspection, current.view, current.false_findings ? 'depth_overlay' : 'level_of_detection')}
          alt={
            current.false_findings ? words.inspection.falseFindingsPicture : words.inspection.findablePicture
          }
        />
      )}
    </>
  );
}

/** Shows the baseline check, or only the noise where there is none: without a robot, a view has one capture. */
export function BaselineCheckCard({ inspection, task }: { inspection: Inspection; task: TaskStatus }) {
  const [check, setCheck] = useState<BaselineCheck | null>(null);
  const checking = task.kind === 'check' && task.end === 'running';
  useEffect(() => {
    let current = true;
    setCheck(null);
    api.baselineCheck(inspection.id).then(
      (found) => current && setCheck(found),
      () => undefined,
    );
    return () => {
      current = false;
    };
  }, [inspection.id, checking]);
  if (checking) {
    return (
      <div class="card" data-testid="checking" role="status">
        <h2>{words.inspection.howSmall}</h2>
        <p>{words.inspection.checking}</p>
      </div>
    );
  }
  if (!check) return <NoiseReport task={task} />;
  const checked = check.views.flatMap((view) => view.level_of_detection ?? []);
  const levels = worstOf(checked);
  const expected = findableText(leastFindable(checked.map(({ findable = [] }) => ({ findable }))), check.views.length > 1 ? 'expectedLeast' : 'expected');
  const notes = check.views.map(noteOf).filter((note) => note !== null);
  return (
    <div class="card" data-testid="baseline-check">
      <h2>{words.inspection.howSmall}</h2>
      {expected && <p data-testid="expected">{words.inspection.expected(expected)}</p>}
      {levels && <FindableTable levels={levels} caption={words.inspection.findableHeight} />}
      {levels && (
        <p class="hint">
          {check.views.length > 1 ? words.inspection.checkedLeast : words.inspection.checked}
        </p>
      )}
      {notes.map((note) => (
        <p key={note} class="warn">
          {note}
        </p>
      ))}
      <CheckPicture inspection={inspection} check={check} />
    </div>
  );
}
