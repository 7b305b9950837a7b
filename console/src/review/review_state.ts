// What the review shows; kept while other pages are shown.
import { whole, type Zoom } from '../picture/zoom';
import type { Size } from '../regions/shapes';
import { Store } from '../store';
import type { Group } from './groups';

export type Layer = 'color' | 'depth' | 'binary';
export type Moment = 'after' | 'before' | 'blink';

export interface ReviewState {
  /** Number of the selected group; 0: none. */
  group: number;
  view: number;
  layer: Layer;
  moment: Moment;
  /** Overlays: none during the first look (thesis 4.2.2). */
  findings: boolean;
  uninspected: boolean;
  /** The size of objects of which it is shown where they would have been found; 0: none. */
  findable_mm: number;
  /** Whether what changed glows in the pictures. */
  glow: boolean;
  /** Whether the picture is enlarged to the finding that is selected. */
  closer: boolean;
}

export const firstLook: ReviewState = { group: 0, view: 0, layer: 'color', moment: 'after', findings: false, uninspected: false, findable_mm: 0, glow: false, closer: false };

export const review = new Store<ReviewState>(firstLook);

/** The numbers of the groups that are decided together; null while findings are decided one by one. */
export const several = new Store<number[] | null>(null);

/** The part of the picture that is shown, the same of all layers, moments and views. */
export const reviewZoom = new Store<Zoom>(whole);

/** The change that selects a group and shows a view in which it was found. */
export function selectionOf({ lead }: Group): Partial<ReviewState> {
  return { group: lead.number, ...(lead.view >= 0 && { view: lead.view }) };
}

/** The size of the pictures, in their pixels; a usual one until the first is loaded. */
export const reviewSize = new Store<Size>({ width: 848, height: 480 });

/** Begins the review of another inspection or comparison, with the whole picture. */
export function beginReview(): void {
  review.value = firstLook;
  several.value = null;
  reviewZoom.value = whole;
}

export function show(change: Partial<ReviewState>): void {
  review.value = { ...review.value, ...change };
}
