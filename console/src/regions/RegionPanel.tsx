// The list of regions that are left out of the view, with buttons to save or discard changes.
import { useMemo } from 'preact/hooks';
import { CaptureProgress } from '../inspection/CaptureProgress';
import { isBusy } from '../inspection/inspections';
import { link } from '../link/live_link';
import { useStore } from '../store';
import type { Inspection, Session } from '../types';
import { change, regionsOf, regionState, removeRegion, unsavedViews } from './region_state';
import { percent } from './region_words';
import { saveRegions } from './save_regions';
import { coveredShare } from './shapes';
import { Rich } from '../words/Rich';
import { words } from '../words/words';

function RegionList({ inspection, mayChange }: { inspection: Inspection; mayChange: boolean }) {
  const state = useStore(regionState);
  const regions = regionsOf(inspection, state);
  if (regions.length === 0) return null;
  return (
    <div class="card">
      <h2>{words.page.view(state.view + 1)}</h2>
      <ul class="list">
        {regions.map((_, i) => (
          <li key={i} class="view-row">
            <button type="button" class="wide" aria-pressed={i === state.selected} onClick={() => change({ selected: i, corners: null })}>
              {i === state.selected ? '● ' : ''}
              {words.regions.region(i + 1)}
            </button>
            <button type="button" aria-label={words.regions.removeIt(i + 1)} disabled={!mayChange} onClick={() => removeRegion(inspection, i)}>
              ✕
            </button>
          </li>
        ))}
      </ul>
    </div>
  );
}

function LeftOutShare({ inspection }: { inspection: Inspection }) {
  const state = useStore(regionState);
  const regions = regionsOf(inspection, state);
  const share = useMemo(() => (state.size ? coveredShare(regions, state.size) : null), [regions, state.size]);
  return (
    <p role="status" data-testid="left-out-share">
      <Rich text={words.regions.leftOutOf(state.view + 1, regions.length === 0 ? words.regions.nothing : share === null ? '…' : words.regions.ofPicture(percent(share)))} />
    </p>
  );
}

function Guide({ drawingCorners }: { drawingCorners: boolean }) {
  if (drawingCorners) return <p class="hint">{words.regions.guideCorners}</p>;
  return <p class="hint">{words.regions.guide}</p>;
}

export function RegionPanel({ inspection, session }: { inspection: Inspection; session: Session }) {
  const state = useStore(regionState);
  const task = useStore(link.status)?.task;
  const busy = isBusy(task);
  const operates = session.role !== 'viewer';
  const unsaved = unsavedViews(inspection, state).length > 0;
  return (
    <>
      <div class="panel-body">
        {task && busy && <CaptureProgress task={task} mayCancel={operates} />}
        <div class="card" data-testid="region-panel">
          <h2>{words.regions.leaveOut}</h2>
          <p>{words.regions.purpose}</p>
          {operates ? <Guide drawingCorners={state.corners !== null} /> : <p class="hint">{words.regions.viewer}</p>}
        </div>
        <RegionList inspection={inspection} mayChange={operates && !busy} />
      </div>
      <div class="panel-action">
        <LeftOutShare inspection={inspection} />
        {operates && (
          <>
            {unsaved && inspection.compared_at && (
              <p class="warn" role="status" data-testid="compared-already">
                {words.regions.compared}
              </p>
            )}
            <div class="region-actions">
              <button type="button" class="primary" data-testid="save-regions" disabled={!unsaved || busy || state.corners !== null} onClick={() => void saveRegions(inspection)}>
                {words.regions.save}
              </button>
              <button type="button" data-testid="discard-regions" disabled={!unsaved} onClick={() => change({ drafts: {}, selected: -1, corners: null })}>
                {words.regions.discard}
              </button>
            </div>
          </>
        )}
      </div>
    </>
  );
}
