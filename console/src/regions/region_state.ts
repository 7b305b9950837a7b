// Regions while they are drawn: kept while other pages are looked at, until they are saved.
import { openInspection } from '../inspection/inspections';
import { Store } from '../store';
import type { Corner, Inspection, Polygon } from '../types';
import type { Size } from './shapes';

export interface RegionState {
  /** Of which inspection the rest is. */
  inspection: number | undefined;
  view: number;
  layer: 'color' | 'depth';
  /** Of the picture, as soon as it was loaded. */
  size: Size | null;
  /** What was drawn and is not saved, by view. */
  drafts: Record<number, Polygon[]>;
  /** Which region of the view is selected; -1: none. */
  selected: number;
  /** Corners of a region that is drawn corner by corner, or null. */
  corners: Corner[] | null;
  /** Which region is to have the keyboard's focus as soon as it is shown; -1: the picture; null: nothing is to change. */
  to_focus: number | null;
}

const atFirst: RegionState = { inspection: undefined, view: 0, layer: 'color', size: null, drafts: {}, selected: -1, corners: null, to_focus: null };

export const regionState = new Store<RegionState>(atFirst);

export function change(part: Partial<RegionState>): void {
  regionState.value = { ...regionState.value, ...part };
}

/** Drawings of one inspection are not laid over another one. */
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

/** As they are drawn, saved or not. */
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
