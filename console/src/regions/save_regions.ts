// Sends regions to the server, view by view.
import { attempt, update } from '../inspection/inspections';
import { api } from '../link/api';
import { page } from '../pages';
import type { Inspection } from '../types';
import { change, regionsOf, regionState, unsavedViews } from './region_state';

/** Saves the changed views. A saved view is no longer a draft, even if a later one is refused. */
export async function saveRegions(inspection: Inspection): Promise<void> {
  const saved = await attempt(async () => {
    for (const view of unsavedViews(inspection, regionState.value)) {
      const after = await api.setRegions(inspection.id, view, regionsOf(inspection, regionState.value, view));
      const { [view]: _, ...drafts } = regionState.value.drafts;
      change({ drafts });
      update(after);
    }
  });
  if (!saved) return;
  change({ drafts: {}, selected: -1, corners: null });
  page.value = 'live';
}
