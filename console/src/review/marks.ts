// A finding that a person has marked in a picture, until it is saved with a note.
import { attempt, update } from '../inspection/inspections';
import { api } from '../link/api';
import { Store } from '../store';
import type { Box, Inspection, Stream } from '../types';
import { show } from './review_state';

export interface NewMark {
  bbox: Box;
  /** Where it was marked: in a view of the comparison, or in the live picture. */
  where: { view: number } | { stream: Stream };
}

export const newMark = new Store<NewMark | null>(null);

export async function saveMark(inspection: Inspection, { bbox, where }: NewMark, note: string, person: string): Promise<void> {
  const picture = 'view' in where ? { comparison: inspection.comparison ?? 0, view: where.view } : where;
  await attempt(async () => {
    const after = await api.mark(inspection.id, { ...picture, bbox, note, person });
    newMark.value = null;
    update(after);
    const last = after.marked.at(-1);
    if (last && 'view' in where) show({ findings: true, group: -last.number });
  });
}
