// The tools for drawing regions.
import { useStore } from '../store';
import type { Inspection } from '../types';
import { addRegion, change, regionState, removeRegion } from './region_state';
import { middleRectangle, type Size } from './shapes';

export function RegionTools({ inspection, size }: { inspection: Inspection; size: Size }) {
  const { corners, selected } = useStore(regionState);
  if (!corners) {
    return (
      <div class="region-tools">
        <button type="button" data-testid="add-rectangle" onClick={() => addRegion(inspection, middleRectangle(size))}>
          Add a rectangle
        </button>
        <button type="button" data-testid="draw-corners" onClick={() => change({ corners: [], selected: -1 })}>
          Draw by corners
        </button>
        <button type="button" data-testid="remove-selected" disabled={selected < 0} onClick={() => removeRegion(inspection, selected)}>
          Remove region
        </button>
      </div>
    );
  }
  return (
    <div class="region-tools">
      <button type="button" class="primary" data-testid="close-region" disabled={corners.length < 3} onClick={() => addRegion(inspection, corners)}>
        Close region
      </button>
      <button type="button" data-testid="undo-corner" disabled={corners.length === 0} onClick={() => change({ corners: corners.slice(0, -1) })}>
        Undo corner
      </button>
      <button type="button" data-testid="cancel-region" onClick={() => change({ corners: null })}>
        Cancel
      </button>
    </div>
  );
}
