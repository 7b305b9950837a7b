// The baseline's picture of a view, on which the areas of planned parts are drawn.
import '../regions/regions.css';
import './plan.css';
import { Choice } from '../Choice';
import { isBusy } from '../inspection/inspections';
import { baselineAddress } from '../link/api';
import { link } from '../link/live_link';
import { MarkBar, useMarking } from '../picture/marking';
import { ZoomButtons } from '../picture/ZoomButtons';
import { ZoomPicture } from '../picture/ZoomPicture';
import { useStore } from '../store';
import type { Inspection, Session } from '../types';
import { useState } from 'preact/hooks';
import { change, planOf, planState, planZoom } from './plan_state';
import { PlanShapes } from './PlanShapes';
import { words } from '../words/words';

const usual = { width: 848, height: 480 };

export function PlanEditor({ inspection, session }: { inspection: Inspection; session: Session }) {
  const state = useStore(planState);
  const busy = isBusy(useStore(link.status)?.task);
  const view = Math.min(state.view, inspection.views.length - 1);
  const size = state.size ?? usual;
  // Without a colour imager, the baseline is shown by its depth.
  const [colorless, setColorless] = useState(false);
  const plan = planOf(inspection, view);
  const mayDraw = session.role !== 'viewer' && !busy && !inspection.closing && state.drawn === null && plan?.coordinates !== 'metres';
  const marking = useMarking(mayDraw ? (drawn) => change({ drawn }) : undefined);
  const views: [string, string][] = inspection.views.map((_, i) => [String(i), words.page.view(i + 1)]);
  return (
    <section class="view" aria-label={words.plan.title}>
      {marking.active ? (
        <MarkBar marking={marking} size={size} zoom={planZoom} texts={words.plan.drawTexts} />
      ) : (
        <div class="view-bar">
          {views.length > 1 && <Choice label={words.page.viewLabel} name="plan-view" options={views} value={String(view)} onPick={(next) => change({ view: Number(next), drawn: null })} />}
          <ZoomButtons zoom={planZoom} />
          <button type="button" class="primary" data-testid="plan-draw" disabled={!mayDraw} onClick={marking.begin}>
            {words.plan.draw}
          </button>
        </div>
      )}
      <ZoomPicture
        size={size}
        zoom={planZoom}
        label={words.regions.pictureOfView(view + 1)}
        overlay={(frame) => <PlanShapes plan={plan} drawn={state.drawn} frame={frame} />}
        marking={marking}
      >
        <img
          src={baselineAddress(inspection, view, colorless ? 'depth' : 'color')}
          alt={words.regions.pictureOfView(view + 1)}
          draggable={false}
          data-testid="plan-image"
          onLoad={(event) => change({ size: { width: event.currentTarget.naturalWidth, height: event.currentTarget.naturalHeight } })}
          onError={() => setColorless(true)}
        />
      </ZoomPicture>
    </section>
  );
}
