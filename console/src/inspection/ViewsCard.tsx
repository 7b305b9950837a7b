// The views of the bay, of which both the initial and the final captures are taken.
import { api } from '../link/api';
import { link } from '../link/live_link';
import { useStore } from '../store';
import type { Inspection, Joints } from '../types';
import { attempt, openInspection } from './inspections';

export function ViewsCard({ inspection, enabled }: { inspection: Inspection; enabled: boolean }) {
  const robot = useStore(link.status)?.robot;
  if (!robot) return null;
  const set = (views: Joints[]) =>
    void attempt(async () => {
      openInspection.value = await api.setViews(inspection.id, views);
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
      <h2>Views</h2>
      <p class="hint">Turn the camera to where the work will be, and add the view. Several views may overlap.</p>
      <ul class="list">
        {views.map((view, i) => (
          <li key={`${view.pan_deg} ${view.tilt_deg} ${i}`} class="view-row">
            <span>
              <strong>View {i + 1}</strong> pan {view.pan_deg.toFixed(1)}°, tilt {view.tilt_deg.toFixed(1)}°
            </span>
            <button
              type="button"
              aria-label={`Remove view ${i + 1}`}
              disabled={!enabled || views.length === 1}
              onClick={() => set(views.filter((_, k) => k !== i))}
            >
              ✕
            </button>
          </li>
        ))}
      </ul>
      {known >= 0 && <p class="hint">This is view {known + 1}. Turn the camera to add another one.</p>}
      <button type="button" data-testid="add-view" disabled={!enabled || !here || known >= 0} onClick={() => here && set([...views, here])}>
        Add the current view
      </button>
      <button type="button" data-testid="only-view" disabled={!enabled || !here} onClick={() => here && set([here])}>
        Use only the current view
      </button>
    </div>
  );
}
