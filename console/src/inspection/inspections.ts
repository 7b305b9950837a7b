// The inspection that is open, and the list of all.
import { api, Refusal } from '../link/api';
import { link } from '../link/live_link';
import { Store } from '../store';
import type { Inspection, InspectionSummary, TaskStatus } from '../types';

export const openInspection = new Store<Inspection | null>(null);
export const inspectionList = new Store<InspectionSummary[] | null>(null);
/** The message of the last action that failed, for the user; empty if the last one succeeded. */
export const trouble = new Store<string>('');

const openKey = 'rva-inspection';

/** Runs an action of the user, and shows the reason if it fails. Returns whether it succeeded. */
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

/** Checks are ended by the server when another task is to start. */
function isCheck(task: TaskStatus): boolean {
  return task.kind === 'readiness' || task.kind === 'check';
}

/** Whether a capture or a comparison is running, during which the inspection must not be changed. */
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

/** Why the last capture or comparison failed or was cancelled; a later check does not clear it. */
export const lastFailure = new Store<{ inspection: number; reason: string } | null>(null);

function noteEnd(task: TaskStatus): void {
  if (isCheck(task) || task.inspection === undefined) return;
  const reason =
    task.end === 'cancelled'
      ? 'Cancelled. What was complete is kept: start again to continue.'
      : task.end === 'failed'
        ? (task.problem ?? 'The task failed.')
        : '';
  lastFailure.value = reason === '' ? null : { inspection: task.inspection, reason };
}

/** Reloads the inspection after each task, also one that another client started, since the task may have changed it. */
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
