// The tools for drawing regions.
import { useStore } from '../store';
import type { Inspection } from '../types';
import { addRegion, change, regionState, removeRegion } from './region_state';
import { middleRectangle, type Size } from './shapes';
import { words } from '../words/words';

export function RegionTools({ inspection, size }: { inspection: Inspection; size: Size }) {
  const { corners, selected } = useStore(regionState);
  if (!corners) {
    return (
      <div class="region-tools">
        <button type="button" data-testid="add-rectangle" onClick={() => addRegion(inspection, middleRectangle(size))}>
          {words.regions.addRectangle}
        </button>
        <button type="button" data-testid="draw-corners" onClick={() => change({ corners: [], selected: -1 })}>
          {words.regions.drawByCorners}
        </button>
        <button type="button" data-testid="remove-selected" disabled={selected < 0} onClick={() => removeRegion(inspection, selected)}>
          {words.regions.remove}
        </button>
      </div>
    );
  }
  return (
    <div class="region-tools">
      <button type="button" class="primary" data-testid="close-region" disabled={corners.length < 3} onClick={() => addRegion(inspection, corners)}>
        {words.regions.closeRegion}
      </button>
      <button type="button" data-testid="undo-corner" disabled={corners.length === 0} onClick={() => change({ corners: corners.slice(0, -1) })}>
        {words.regions.undoCorner}
      </button>
      <button type="button" data-testid="cancel-region" onClick={() => change({ corners: null })}>
        {words.page.cancel}
      </button>
    </div>
  );
}
