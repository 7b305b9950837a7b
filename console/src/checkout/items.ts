// The check-out list of an inspection: what of it is accounted for.
import type { Inspection, Item, ItemRequest } from '../types';

/** The last statement on an item as a request of its own; nothing accounted for where there is none. */
export function statementOn(item: Item): Omit<ItemRequest, 'person'> {
  const last = item.statements.at(-1);
  return { returned: last?.returned ?? 0, used: last?.used ?? 0, lost: last?.lost ?? 0, released: last?.released ?? false, note: last?.note ?? '' };
}

/** Items that prevent closing: not accounted for, or lost and not released. */
export function unaccounted({ items }: Inspection): Item[] {
  return items.filter((item) => item.state === 'out' || item.state === 'lost');
}

function quoted(cell: string): string {
  return `"${cell.replaceAll('"', '""')}"`;
}

/** A list of one line, as the server reads it. */
export function lineOf(name: string, identity: string, quantity: number): string {
  return `item,number,quantity\n${quoted(name)},${quoted(identity)},${quantity}\n`;
}
