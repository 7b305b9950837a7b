// Keeps the page's address to what is shown, so that it can be bookmarked, and so that *Back* leads to what was shown
// before.
import { addressIn, textOf, type Address } from './address';
import { open, openInspection } from './inspection/inspections';
import { page as shownPage } from './pages';
import { review } from './review/review_state';

// Set while an address is being opened, until its page is shown.
let requested: Address | null = null;

/** The address that is being opened, once. */
export function takeRequested(): Address | null {
  const taken = requested;
  requested = null;
  return taken;
}

function write(): void {
  if (requested) return;
  const id = openInspection.value?.id ?? null;
  const now = textOf({ id, page: shownPage.value, finding: review.value.group });
  if (now === location.hash) return;
  const before = addressIn(location.hash);
  const isElsewhere = before.id !== id || before.page !== undefined && before.page !== shownPage.value;
  if (isElsewhere) history.pushState(null, '', now);
  else history.replaceState(null, '', now);
}

/** Opens what the page's address leads to; the list where that is not there. */
export async function openAddress(): Promise<void> {
  const address = addressIn(location.hash);
  if (address.id === null) {
    await open(null);
    return;
  }
  requested = address;
  const shown = openInspection.value;
  try {
    await open(address.id);
  } catch {
    requested = null;
    await open(null);
    return;
  }
  // The page of an inspection that was open already is not chosen anew.
  if (shown?.id !== address.id) return;
  requested = null;
  if (address.page) shownPage.value = address.page;
}

export function followAddress(): void {
  addEventListener('popstate', () => void openAddress().catch(() => undefined));
  for (const store of [openInspection, shownPage, review]) store.subscribe(write);
}
