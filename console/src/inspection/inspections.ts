// The inspection that is open, and the list of all.
import { api, Refusal } from '../link/api';
import { link } from '../link/live_link';
import { Store } from '../store';
import type { Inspection, InspectionSummary, TaskStatus } from '../types';

export const openInspection = new Store<Inspection | null>(null);
export const inspectionList = new Store<InspectionSummary[] | null>(null);
/** What the server refused last, for a person. */
export const trouble = new Store<string>('');

const openKey = 'rva-inspection';

/** Runs what a person asked for, and shows why where it is refused. */
export async function attempt(work: () => Promise<unknown>): Promise<boolean> {
  trouble.value = '';
  try {
    await work();
    return true;
  } catch (error) {
    trouble.value = error instanceof Refusal ? error.message : String(error);
    return false;
  }
}

/** Checks end by themselves when something else is to be done. */
function isCheck(task: TaskStatus): boolean {
  return task.kind === 'readiness' || task.kind === 'check';
}

/** While a capture or a comparison runs, nothing of the inspection is changed. */
export function isBusy(task: TaskStatus | undefined): boolean {
  return task?.end === 'running' && !isCheck(task);
}

export async function loadList(): Promise<void> {
  inspectionList.value = (await api.inspections()).inspections;
}

export async function open(id: number | null): Promise<void> {
  if (id === null) {
    sessionStorage.removeItem(openKey);
    openInspection.value = null;
    await loadList();
    return;
  }
  openInspection.value = await api.inspection(id);
  sessionStorage.setItem(openKey, String(id));
}

export async function reopen(): Promise<void> {
  const id = Number(sessionStorage.getItem(openKey));
  if (id > 0) await open(id).catch(() => open(null));
  else await loadList();
}

/** How the last capture or comparison ended, where it did not end well: a check after it does not wipe it away. */
export const lastFailure = new Store<{ inspection: number; says: string } | null>(null);

function noteEnd(task: TaskStatus): void {
  if (isCheck(task) || task.inspection === undefined) return;
  const says =
    task.end === 'cancelled'
      ? 'Cancelled. What was complete is kept: start again to go on.'
      : task.end === 'failed'
        ? (task.problem ?? 'It failed.')
        : '';
  lastFailure.value = says === '' ? null : { inspection: task.inspection, says };
}

/** After each task, whoever started it: what it did is in the inspection. */
export function followTasks(): void {
  let seen = '';
  link.status.subscribe(() => {
    const task = link.status.value?.task;
    if (!task) return;
    const now = `${task.number} ${task.end} ${task.kind}`;
    if (now === seen) return;
    seen = now;
    noteEnd(task);
    const id = openInspection.value?.id;
    if (id !== undefined) void open(id).catch(() => undefined);
    else void loadList().catch(() => undefined);
  });
}
