// The inspection that is open, and the list of all.
import { api } from '../link/api';
import { link } from '../link/live_link';
import { refusalOf, type Refusal } from '../link/refusal';
import { Store } from '../store';
import type { Inspection, InspectionSummary, Stage, TaskStatus } from '../types';
import { words } from '../words/words';

export const openInspection = new Store<Inspection | null>(null);
export const inspectionList = new Store<InspectionSummary[] | null>(null);
/** Whether there are more inspections than those of the list. */
export const hasMore = new Store(false);

/** Which inspections the list shows; empty texts have no effect. */
export interface ListFilter {
  /** Words that an entry contains. */
  text: string;
  stage: Stage | '';
  /** First and last day, YYYY-MM-DD, in the time zone of this browser. */
  from: string;
  until: string;
}
export const wholeList: ListFilter = { text: '', stage: '', from: '', until: '' };
export const listFilter = new Store<ListFilter>(wholeList);
/** Why the last action failed; null if it succeeded. */
export const trouble = new Store<Refusal | null>(null);

/** Runs an action of the user, and shows the reason if it fails. Returns whether it succeeded. */
export async function attempt(work: () => Promise<unknown>): Promise<boolean> {
  trouble.value = null;
  try {
    await work();
    return true;
  } catch (error) {
    trouble.value = refusalOf(error);
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

const page_entries = 50;

function startOf(day: string, later_days = 0): string {
  if (day === '') return '';
  const date = new Date(`${day}T00:00`);
  date.setDate(date.getDate() + later_days);
  return date.toISOString();
}

/** The filter of the list as the parameters of a query. */
export function listQuery(): Record<string, string> {
  const { text, stage, from, until } = listFilter.value;
  return { text, stage, from: startOf(from), until: startOf(until, 1) };
}

/** Loads the list from its beginning, or the entries that follow those that are shown. */
export async function loadList(further = false): Promise<void> {
  const filter = listFilter.value;
  const shown = further ? (inspectionList.value ?? []) : [];
  const { inspections } = await api.inspections({
    ...listQuery(),
    before: String(shown.at(-1)?.id ?? ''),
    most: String(page_entries + 1),
  });
  if (filter !== listFilter.value) return; // a later request has been sent
  hasMore.value = inspections.length > page_entries;
  inspectionList.value = [...shown, ...inspections.slice(0, page_entries)];
}

// How often an inspection or the list was asked for: what arrives for an earlier request is not shown.
let asked = 0;

/** Opens an inspection, or the list, unless another one is asked for in the meantime. */
export async function open(id: number | null): Promise<void> {
  const request = ++asked;
  if (id === null) {
    openInspection.value = null;
    await loadList();
    return;
  }
  const opened = await api.inspection(id);
  if (request === asked) openInspection.value = opened;
}

/** Shows an inspection as the server has it now, unless it was left in the meantime. */
export function update(inspection: Inspection): void {
  if (openInspection.value?.id === inspection.id) openInspection.value = inspection;
}

// What was shown in the meantime is newer than what this request may bring, and is asked for again.
async function reload(id: number): Promise<void> {
  const before = openInspection.value;
  const now = await api.inspection(id);
  if (openInspection.value === before) update(now);
  else if (openInspection.value?.id === id) await reload(id);
}

/** Why the last capture or comparison failed or was cancelled; a later check does not clear it. */
export const lastFailure = new Store<{ inspection: number; reason: string } | null>(null);

function noteEnd(task: TaskStatus): void {
  if (isCheck(task) || task.inspection === undefined) return;
  const reason =
    task.end === 'cancelled'
      ? words.inspection.cancelled
      : task.end === 'failed'
        ? (task.problem ?? words.inspection.failed)
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
    if (id !== undefined) void reload(id).catch(() => undefined);
    else void loadList().catch(() => undefined);
  });
}
