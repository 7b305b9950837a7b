// The address of what the console shows.
import { pages, type Page } from './pages';

export interface Address {
  /** null: the list of inspections */
  id: number | null;
  page?: Page;
  /** Number of the finding that is selected. */
  finding?: number;
}

/** `#/inspections/12/review/3`; `#/` for the list. */
export function textOf({ id, page, finding }: Address): string {
  if (id === null) return '#/';
  const parts = [id, ...(page ? [page] : []), ...(page === 'review' && finding ? [finding] : [])];
  return `#/inspections/${parts.join('/')}`;
}

/** What an address leads to: the list if it is none of ours. */
export function addressIn(hash: string): Address {
  const [, id, page, finding] = /^#\/inspections\/(\d{1,15})(?:\/([a-z]+)(?:\/(-?\d{1,9}))?)?$/.exec(hash) ?? [];
  if (id === undefined) return { id: null };
  const known = pages.find((name) => name === page);
  return { id: Number(id), ...(known && { page: known }), ...(finding && { finding: Number(finding) }) };
}
