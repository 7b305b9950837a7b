// Keeps the page's address to what is shown, so that it can be bookmarked, and so that *Back* leads to what was shown
// before.
import { addressIn, textOf, type Address } from './address';
import { open, openInspection } from './inspection/inspections';
import { api } from './link/api';
import { page as shownPage } from './pages';
import { review } from './review/review_state';
import { earlierRound, numbered, showRound, type NumberedRound } from './review/rounds';
import { trendsShown } from './trends/trends';

/** An address, with the round to which it leads; null: the current one. */
interface Destination extends Address {
  earlier: NumberedRound | null;
}

// Set while an address is being opened, until its page is shown.
let requested: Destination | null = null;

/** Shows where the address that is being opened leads to, once, as one step of the browser's history. */
export function showRequested(show: (destination: Destination | null) => void): void {
  const destination = requested;
  show(destination);
  requested = null;
  if (destination) write();
}

function write(): void {
  if (requested) return;
  const id = openInspection.value?.id ?? null;
  const round = earlierRound.value?.comparison;
  const now = textOf({ id, trends: trendsShown.value, ...(round && { round }), page: shownPage.value, finding: review.value.group });
  if (now === location.hash) return;
  const before = addressIn(location.hash);
  const isElsewhere = before.id !== id || id === null && (before.trends ?? false) !== trendsShown.value || before.round !== round || before.page !== undefined && before.page !== shownPage.value;
  if (isElsewhere) history.pushState(null, '', now);
  else history.replaceState(null, '', now);
}

async function roundOf(id: number, comparison: number): Promise<NumberedRound | null> {
  const { rounds } = await api.rounds(id);
  return numbered(rounds).find((round) => round.comparison === comparison) ?? null;
}

/** Opens what the page's address leads to; the list where that is not there, and the current round where a round is not. */
export async function openAddress(): Promise<void> {
  const address = addressIn(location.hash);
  if (address.id === null) {
    trendsShown.value = address.trends ?? false;
    await open(null);
    return;
  }
  requested = { ...address, earlier: null };
  const shown = openInspection.value;
  try {
    if (address.round !== undefined) requested = { ...address, earlier: await roundOf(address.id, address.round) };
    await open(address.id);
  } catch {
    requested = null;
    await open(null);
    return;
  }
  // Something else was opened in the meantime.
  if (openInspection.value?.id !== address.id) {
    requested = null;
    write();
    return;
  }
  // The page of an inspection that was open already is not chosen anew.
  if (shown?.id !== address.id) return;
  showRequested((destination) => {
    showRound(destination?.earlier ?? null);
    if (address.page) shownPage.value = address.page;
  });
}

export function followAddress(): void {
  addEventListener('popstate', () => void openAddress().catch(() => undefined));
  for (const store of [openInspection, shownPage, review, earlierRound, trendsShown]) store.subscribe(write);
}
