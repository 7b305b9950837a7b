// Earlier rounds of an inspection, of which the pictures and findings are shown as they were.
import { openInspection } from '../inspection/inspections';
import { Store } from '../store';
import type { Inspection, Round } from '../types';
import { beginReview, show } from './review_state';

/** The round that the review shows instead of the current one; null for the current one. */
export const earlierRound = new Store<Round | null>(null);

/** An inspection as it was after a round. Nothing of it can be changed. */
export function asItWas(inspection: Inspection, { comparison, compared_at, final, compared, findings }: Round): Inspection {
  return { ...inspection, comparison, compared_at, compared, findings, marked: [], ...(final && { final }) };
}

export function showRound(round: Round | null): void {
  earlierRound.value = round;
  beginReview();
  show({ findings: true, uninspected: true });
}

/** Shows the current round again whenever another inspection is opened or this one was compared again. */
export function followRounds(): void {
  let seen = '';
  openInspection.subscribe(() => {
    const inspection = openInspection.value;
    const now = `${inspection?.id} ${inspection?.comparison}`;
    if (now === seen) return;
    seen = now;
    earlierRound.value = null;
  });
}
