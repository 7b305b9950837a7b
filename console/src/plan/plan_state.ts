// The plan of the work of each view: what is drawn of it, and how it is saved.
import { attempt, openInspection, update } from '../inspection/inspections';
import { api } from '../link/api';
import type { Zoom } from '../picture/zoom';
import { whole } from '../picture/zoom';
import type { Size } from '../regions/shapes';
import { Store } from '../store';
import type { Box, Inspection, Plan, PlanPart, PlanPoints } from '../types';

export interface PlanState {
  view: number;
  /** The size of the picture; null until it is loaded. */
  size: Size | null;
  /** An area that was drawn, of parts that are still to be described. */
  drawn: Box | null;
}

const atFirst: PlanState = { view: 0, size: null, drawn: null };
export const planState = new Store<PlanState>(atFirst);
export const planZoom = new Store<Zoom>(whole);

// What was drawn for one inspection is not added to the plan of another one.
let inspection: number | undefined;
openInspection.subscribe(() => {
  if (openInspection.value?.id === inspection) return;
  inspection = openInspection.value?.id;
  planState.value = atFirst;
  planZoom.value = whole;
});

export function change(part: Partial<PlanState>): void {
  planState.value = { ...planState.value, ...part };
}

export function planOf(inspection: Inspection, view: number): Plan | undefined {
  return inspection.views[view]?.plan;
}

/** The corners of a box, on the borders of its first and last pixels. */
export function cornersOf([u, v, width, height]: Box): PlanPoints {
  const [left, top, right, bottom] = [u - 0.5, v - 0.5, u + width - 0.5, v + height - 0.5];
  return [[left, top], [right, top], [right, bottom], [left, bottom]];
}

/** Sends a plan file. An empty one removes the plan. */
export async function savePlan(inspection: Inspection, view: number, text: string): Promise<boolean> {
  return attempt(async () => {
    update(await api.setPlan(inspection.id, view, text));
  });
}

// Whatever the coordinates of the plan are, its parts keep theirs.
function textOf(plan: Plan | undefined, parts: PlanPart[]): string {
  if (parts.length === 0) return '';
  return JSON.stringify({ format: 'rva-plan', version: 1, coordinates: plan?.coordinates ?? 'pixels', parts });
}

export function addPart(inspection: Inspection, view: number, part: PlanPart): Promise<boolean> {
  const plan = planOf(inspection, view);
  return savePlan(inspection, view, textOf(plan, [...(plan?.parts ?? []), part]));
}

export function removePart(inspection: Inspection, view: number, name: string): Promise<boolean> {
  const plan = planOf(inspection, view);
  return savePlan(inspection, view, textOf(plan, (plan?.parts ?? []).filter((part) => part.name !== name)));
}
