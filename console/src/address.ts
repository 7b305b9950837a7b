// The address of what the console shows.
import { pages, type Page } from './pages';

export interface Address {
  /** null: the list of inspections */
  id: number | null;
  /** Whether the list is shown with the trends. */
  trends?: boolean;
  /** Number of an earlier comparison that is shown as it was; missing for the valid one. */
  round?: number;
  page?: Page;
  /** Number of the finding that is selected. */
  finding?: number;
}

/** `#/inspections/12/review/3`, or of an earlier comparison `#/inspections/12/rounds/1/space`; `#/` for the list, `#/trends` with the trends. */
export function textOf({ id, trends, round, page, finding }: Address): string {
  if (id === null) return trends ? '#/trends' : '#/';
  const parts = [id, ...(round ? ['rounds', round] : []), ...(page ? [page] : []), ...(page === 'review' && finding ? [finding] : [])];
  return `#/inspections/${parts.join('/')}`;
}

/** What an address leads to: the list if it is none of ours. */
export function addressIn(hash: string): Address {
  if (hash === '#/trends') return { id: null, trends: true };
  const [, id, round, page, finding] = /^#\/inspections\/(\d{1,15})(?:\/rounds\/(\d{1,9}))?(?:\/([a-z]+)(?:\/(-?\d{1,9}))?)?$/.exec(hash) ?? [];
  if (id === undefined) return { id: null };
  const known = pages.find((name) => name === page);
  return { id: Number(id), ...(round && { round: Number(round) }), ...(known && { page: known }), ...(finding && { finding: Number(finding) }) };
}
