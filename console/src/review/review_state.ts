// What the review shows; kept while other pages are shown.
import { whole, type Zoom } from '../picture/zoom';
import { Store } from '../store';

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
  /** Whether what changed glows in the pictures. */
  glow: boolean;
  /** Whether the picture is enlarged to the finding that is selected. */
  closer: boolean;
}

export const firstLook: ReviewState = { group: 0, view: 0, layer: 'color', moment: 'after', findings: false, uninspected: false, glow: false, closer: false };

export const review = new Store<ReviewState>(firstLook);

/** The part of the picture that is shown, the same of all layers, moments and views. */
export const reviewZoom = new Store<Zoom>(whole);

export function show(change: Partial<ReviewState>): void {
  review.value = { ...review.value, ...change };
}
