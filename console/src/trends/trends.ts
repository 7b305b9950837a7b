// What inspections showed by zone and month, of those that the list shows.
import { api } from '../link/api';
import { inspectionList, listFilter, listQuery } from '../inspection/inspections';
import { Store } from '../store';
import type { Trends, VerdictCounts } from '../types';
import { words } from '../words/words';

/** Whether the trends are shown beside the list. */
export const trendsShown = new Store(false);
export const trends = new Store<Trends | null>(null);

const names = { removed: 'debris-removed', left: 'debris', unreachable: 'debris-unreachable', installed: 'installed-work', false_alarms: 'false-alarm' } as const;

export function nameOf(verdict: keyof VerdictCounts): string {
  return verdict === 'undecided' ? words.trends.undecided : words.finding.verdicts[names[verdict]];
}

/** Loads the trends of the inspections that match the filter of the list. */
export async function loadTrends(): Promise<void> {
  const filter = listFilter.value;
  const loaded = await api.trends(listQuery());
  if (filter === listFilter.value) trends.value = loaded; // otherwise a later request has been sent
}

// Sums over many inspections take seconds, so that they are not asked for at each letter of a search.
const pause_ms = 500;

/** Loads the trends now, and again once the list has not changed for half a second. Returns how to end that. */
export function followList(onProblem: (error: unknown) => void): () => void {
  const load = () => void loadTrends().catch(onProblem);
  load();
  let timer: ReturnType<typeof setTimeout> | undefined;
  const end = inspectionList.subscribe(() => {
    clearTimeout(timer);
    timer = setTimeout(load, pause_ms);
  });
  return () => {
    clearTimeout(timer);
    end();
  };
}
