// The views of the bay, of which both the initial and the final captures are taken.
import { api } from '../link/api';
import { link } from '../link/live_link';
import { useStore } from '../store';
import type { Inspection, Joints } from '../types';
import { attempt, update } from './inspections';
import { Rich } from '../words/Rich';
import { decimal, words } from '../words/words';

export function ViewsCard({ inspection, enabled }: { inspection: Inspection; enabled: boolean }) {
  const robot = useStore(link.status)?.robot;
  if (!robot) return null;
  const set = (views: Joints[]) =>
    void attempt(async () => {
      update(await api.setViews(inspection.id, views));
    });
  // A view from the middle of a motion would be one that nobody chose.
  const moves = robot.driving || robot.lent;
  const here: Joints | null =
    moves || robot.pan_deg === undefined || robot.tilt_deg === undefined ? null : { pan_deg: robot.pan_deg, tilt_deg: robot.tilt_deg };
  const { views } = inspection;
  const same_deg = 2;
  const known = here
    ? views.findIndex((view) => Math.abs(view.pan_deg - here.pan_deg) < same_deg && Math.abs(view.tilt_deg - here.tilt_deg) < same_deg)
    : -1;
  return (
    <div class="card" data-testid="views">
      <h2>{words.inspection.views}</h2>
      <p class="hint">{words.inspection.turnThenAdd}</p>
      <ul class="list">
        {views.map((view, i) => (
          <li key={`${view.pan_deg} ${view.tilt_deg} ${i}`} class="view-row">
            <span>
              <Rich text={words.inspection.panAndTilt(i + 1, decimal(view.pan_deg, 1), decimal(view.tilt_deg, 1))} />
            </span>
            <button
              type="button"
              aria-label={words.inspection.removeView(i + 1)}
              disabled={!enabled || views.length === 1}
              onClick={() => set(views.filter((_, k) => k !== i))}
            >
              ✕
            </button>
          </li>
        ))}
      </ul>
      {known >= 0 && <p class="hint">{words.inspection.thisIsView(known + 1)}</p>}
      <button type="button" data-testid="add-view" disabled={!enabled || !here || known >= 0} onClick={() => here && set([...views, here])}>
        {words.inspection.addView}
      </button>
      <button type="button" data-testid="only-view" disabled={!enabled || !here} onClick={() => here && set([here])}>
        {words.inspection.onlyView}
      </button>
    </div>
  );
}
