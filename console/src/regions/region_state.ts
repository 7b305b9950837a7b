// Regions while they are drawn. Unsaved ones are kept while other pages are shown.
import { openInspection } from '../inspection/inspections';
import { Store } from '../store';
import type { Corner, Inspection, Polygon } from '../types';
import type { Size } from './shapes';

export interface RegionState {
  /** The inspection to which the rest belongs. */
  inspection: number | undefined;
  view: number;
  layer: 'color' | 'depth';
  /** The size of the picture; null until it is loaded. */
  size: Size | null;
  /** Unsaved regions, by view. */
  drafts: Record<number, Polygon[]>;
  /** Which region of the view is selected; -1: none. */
  selected: number;
  /** The corners so far of a region that is drawn corner by corner; null if there is none. */
  corners: Corner[] | null;
  /** The region that gets the keyboard's focus once it is shown; -1: the picture; null: the focus does not change. */
  to_focus: number | null;
}

const atFirst: RegionState = { inspection: undefined, view: 0, layer: 'color', size: null, drafts: {}, selected: -1, corners: null, to_focus: null };

export const regionState = new Store<RegionState>(atFirst);

export function change(part: Partial<RegionState>): void {
  regionState.value = { ...regionState.value, ...part };
}

/** Discards the drawings when another inspection is opened. */
export function followInspection(): void {
  openInspection.subscribe(() => {
    const inspection = openInspection.value?.id;
    if (inspection !== regionState.value.inspection) regionState.value = { ...atFirst, inspection };
  });
}

export function showView(view: number): void {
  change({ view, selected: -1, corners: null });
}

export function savedRegions(inspection: Inspection, view: number): Polygon[] {
  return inspection.views[view]?.ignore ?? [];
}

/** The regions of a view as they are drawn, saved or not. */
export function regionsOf(inspection: Inspection, state: RegionState, view = state.view): Polygon[] {
  return state.drafts[view] ?? savedRegions(inspection, view);
}

export function unsavedViews(inspection: Inspection, state: RegionState): number[] {
  const differs = (view: number) => JSON.stringify(regionsOf(inspection, state, view)) !== JSON.stringify(savedRegions(inspection, view));
  return inspection.views.map((_, view) => view).filter(differs);
}

function draw(regions: Polygon[], part: Partial<RegionState>): void {
  const { view, drafts } = regionState.value;
  change({ drafts: { ...drafts, [view]: regions }, ...part });
}

export function addRegion(inspection: Inspection, region: Polygon): void {
  const regions = [...regionsOf(inspection, regionState.value), region];
  draw(regions, { selected: regions.length - 1, corners: null, to_focus: regions.length - 1 });
}

export function replaceRegion(inspection: Inspection, at: number, region: Polygon): void {
  const regions = regionsOf(inspection, regionState.value);
  draw(regions.map((other, i) => (i === at ? region : other)), { selected: at });
}

export function removeRegion(inspection: Inspection, at: number): void {
  const regions = regionsOf(inspection, regionState.value).filter((_, i) => i !== at);
  const next = Math.min(at, regions.length - 1);
  draw(regions, { selected: next, to_focus: next });
}
