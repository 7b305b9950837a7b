// Earlier rounds of an inspection, of which the pictures and findings are shown as they were.
import { openInspection } from '../inspection/inspections';
import { Store } from '../store';
import type { Inspection, MarkedFinding, Round } from '../types';
import { beginReview, show } from './review_state';

export interface NumberedRound extends Round {
  /** From 1, as people count them; numbers of comparisons may have gaps. */
  number: number;
}

export function numbered(rounds: Round[]): NumberedRound[] {
  return rounds.map((round, i) => ({ ...round, number: rounds.length - i }));
}

/** The round that the review and the 3D page show instead of the current one; null for the current one. */
export const earlierRound = new Store<NumberedRound | null>(null);

const noMarks: MarkedFinding[] = [];

/** An inspection as it was after a round. Nothing of it can be changed. */
export function asItWas(inspection: Inspection, { comparison, compared_at, final, compared, findings }: Round): Inspection {
  return { ...inspection, comparison, compared_at, compared, findings, marked: noMarks, ...(final && { final }) };
}

/** @param round null for the current one, as is the round of the comparison that is valid */
export function showRound(round: NumberedRound | null): void {
  const earlier = round && round.comparison !== openInspection.value?.comparison ? round : null;
  if (earlier?.comparison === earlierRound.value?.comparison) return;
  earlierRound.value = earlier;
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
