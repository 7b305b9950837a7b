// The server's HTTP API.
import type {
  BaselineCheck,
  CaptureRequest,
  CheckOutRequest,
  CloseRequest,
  DecisionsRequest,
  Empty,
  ErrorAnswer,
  ExposureRequest,
  FreezeRequest,
  FrozenPicture,
  GivenDecision,
  Inspection,
  InspectionList,
  ItemRequest,
  Joints,
  LampRequest,
  MapMeasureRequest,
  MarkRequest,
  Measurement,
  MeasureRequest,
  Order,
  PlanRequest,
  Point3,
  Polygon,
  RegionsRequest,
  RoundList,
  Session,
  SideName,
  SignInRequest,
  SignRequest,
  SimulationRequest,
  SnapshotRequest,
  Stream,
  Trends,
  ViewMeasureRequest,
  ViewsRequest,
} from '../types';
import { clientId } from './client';
import { Refusal } from './refusal';
import { words } from '../words/words';

async function answerTo(path: string, request: RequestInit): Promise<Response> {
  try {
    return await fetch(path, request);
  } catch {
    throw new Refusal('console', words.page.noServer);
  }
}

async function call<T>(method: string, path: string, body?: unknown): Promise<T> {
  const response = await answerTo(path, {
    method,
    headers: { 'Content-Type': 'application/json', 'X-RVA-Client': clientId },
    ...(body === undefined ? {} : { body: JSON.stringify(body) }),
  });
  const answer: unknown = await response.json().catch(() => ({}));
  if (response.ok) return answer as T;
  throw refusalIn(response, answer);
}

function refusalIn({ status, statusText }: Response, answer: unknown): Refusal {
  const { error } = answer as Partial<ErrorAnswer>;
  return new Refusal(error?.code ?? 'unknown', error?.message ?? statusText, status);
}

/** A request that needs no body. */
function post<T>(path: string): Promise<T> {
  return call<T>('POST', path, {});
}

function send<Request, Answer>(method: 'POST' | 'PUT', path: string, request: Request): Promise<Answer> {
  return call<Answer>(method, path, request);
}

function queryOf(filter: Record<string, string>): URLSearchParams {
  return new URLSearchParams(Object.entries(filter).filter(([, value]) => value !== ''));
}

/** @param ending '.csv' for a spreadsheet */
export function trendsAddress(ending: '' | '.csv', filter: Record<string, string>): string {
  return `/api/trends${ending}?${queryOf(filter)}`;
}

export const api = {
  session: () => call<Session>('GET', '/api/session'),
  signIn: (name: string, password: string) => send<SignInRequest, Empty>('POST', '/api/sign-in', { name, password }),
  signOut: () => post<Empty>('/api/sign-out'),
  /** @param filter parameters of the query (docs/api.md); empty values have no effect */
  inspections: (filter: Record<string, string>) => call<InspectionList>('GET', `/api/inspections?${queryOf(filter)}`),
  /** @param filter as that of the list */
  trends: (filter: Record<string, string>) => call<Trends>('GET', trendsAddress('', filter)),
  inspection: (id: number) => call<Inspection>('GET', `/api/inspections/${id}`),
  /** Refused once something has been captured or marked. */
  remove: (id: number) => call<Empty>('DELETE', `/api/inspections/${id}`),
  rounds: (id: number) => call<RoundList>('GET', `/api/inspections/${id}/rounds`),
  /** Refused with 404 until there is one. */
  baselineCheck: (id: number) => call<BaselineCheck>('GET', `/api/inspections/${id}/baseline-check`),
  begin: (order: Order) => send<Order, Inspection>('POST', '/api/inspections', order),
  setViews: (id: number, views: Joints[]) => send<ViewsRequest, Inspection>('PUT', `/api/inspections/${id}/views`, { views }),
  /** Replaces what is left out of one view; an earlier comparison becomes outdated. */
  setRegions: (id: number, view: number, ignore: Polygon[]) =>
    send<RegionsRequest, Inspection>('PUT', `/api/inspections/${id}/regions`, { view, ignore }),
  /** Replaces the plan of one view by a plan file, or removes it; an earlier comparison becomes outdated. */
  setPlan: (id: number, view: number, text: string) => send<PlanRequest, Inspection>('PUT', `/api/inspections/${id}/views/${view}/plan`, { text }),
  capture: (id: number, side: SideName, person: string, replaced: boolean) =>
    send<CaptureRequest, Empty>('POST', `/api/inspections/${id}/capture`, { side, person, replaced }),
  compare: (id: number) => post<Empty>(`/api/inspections/${id}/compare`),
  /** Decides on findings of this comparison, on all or on none; refused if the inspection has been compared again since. */
  decideAll: ({ id, comparison = 0 }: Inspection, decisions: GivenDecision[], person: string) =>
    send<DecisionsRequest, Inspection>('POST', `/api/inspections/${id}/decisions`, { comparison, decisions, person }),
  mark: (id: number, mark: MarkRequest) => send<MarkRequest, Inspection>('POST', `/api/inspections/${id}/marked`, mark),
  /** Refused if the inspection has been compared again since; it does not change afterwards. */
  close: ({ id, comparison = 0 }: Inspection, note: string, person: string) =>
    send<CloseRequest, Inspection>('POST', `/api/inspections/${id}/close`, { comparison, note, person }),
  /** Adds the lines of a CSV text to the check-out list, all or none. */
  checkOut: (id: number, csv: string, person: string) => send<CheckOutRequest, Inspection>('POST', `/api/inspections/${id}/items`, { csv, person }),
  /** States what became of an item; earlier statements stay in the record. */
  stateItem: (id: number, item: number, request: ItemRequest) => send<ItemRequest, Inspection>('POST', `/api/inspections/${id}/items/${item}`, request),
  /** Starts the task that writes the signed package of a closed inspection. */
  sign: ({ id }: Inspection, request: SignRequest) => send<SignRequest, Empty>('POST', `/api/inspections/${id}/sign`, request),
  checkReadiness: () => post<Empty>('/api/readiness'),
  cancel: () => post<Empty>('/api/cancel'),
  /** Sets the exposure of the infrared imagers; refused during a capture. */
  setExposure: (request: ExposureRequest) => send<ExposureRequest, Empty>('PUT', '/api/camera/exposure', request),
  /** Sets the brightness of the robot's lamp; refused during a capture. */
  setLamp: (request: LampRequest) => send<LampRequest, Empty>('PUT', '/api/robot/lamp', request),
  measure: (request: MeasureRequest) => send<MeasureRequest, Measurement>('POST', '/api/measure', request),
  /** Keeps the live picture still, for measuring and for a snapshot. */
  freeze: (stream: Stream) => send<FreezeRequest, FrozenPicture>('POST', '/api/freeze', { stream }),
  /** Keeps a picture with a note; it is no finding. */
  keepSnapshot: (id: number, request: SnapshotRequest) => send<SnapshotRequest, Inspection>('POST', `/api/inspections/${id}/snapshots`, request),
  /** Measures in the pictures of a view of a comparison, before or after the work. */
  measureView: ({ id, comparison = 0 }: Inspection, view: number, request: ViewMeasureRequest) =>
    send<ViewMeasureRequest, Measurement>('POST', `/api/inspections/${id}/rounds/${comparison}/views/${view}/measure`, request),
  /** A cloud of points of a comparison (.ply); null where it has none. */
  cloud: async ({ id, comparison = 0 }: Inspection, name: 'map' | 'changes', signal: AbortSignal) => {
    const response = await answerTo(`/api/inspections/${id}/rounds/${comparison}/${name}`, { signal });
    if (response.ok) return response.arrayBuffer();
    const notFound = 404;
    if (response.status === notFound) return null;
    throw refusalIn(response, await response.json().catch(() => ({})));
  },
  /** Measures between two points of the map of a comparison. */
  measureMap: ({ id, comparison = 0 }: Inspection, points_m: [Point3, Point3]) =>
    send<MapMeasureRequest, Measurement>('POST', `/api/inspections/${id}/rounds/${comparison}/map/measure`, { points_m }),
  simulateWork: (done: boolean) => send<SimulationRequest, Empty>('POST', '/api/simulation', { done }),
};

/** The URL of a picture of a view in an inspection's comparison, which may be an earlier one (rounds.ts). */
export function pictureAddress(inspection: Inspection, view: number, name: string): string {
  return `/api/inspections/${inspection.id}/rounds/${inspection.comparison ?? 0}/views/${view}/${name}.png`;
}

/** The URL of the picture in which a person marked a finding. */
export function markedAddress(inspection: Inspection, mark: number): string {
  return `/api/inspections/${inspection.id}/marked/${mark}/picture.png`;
}

/** The URL of a picture that was frozen. */
export function frozenAddress(frozen: number): string {
  return `/api/frozen/${frozen}/picture.png`;
}

/** The URL of a picture that was kept with a note. */
export function snapshotAddress(inspection: Inspection, number: number): string {
  return `/api/inspections/${inspection.id}/snapshots/${number}/picture.png`;
}

/** The URL of the report on an inspection, a page of its own. */
export function reportAddress(inspection: Inspection): string {
  return `/api/inspections/${inspection.id}/report`;
}

/** The URL of the same report as a PDF file. */
export function pdfReportAddress(inspection: Inspection): string {
  return `/api/inspections/${inspection.id}/report.pdf`;
}

/** The URL of a picture of a view's baseline. Colour and the pictures of the baseline check may be missing. */
export function baselineAddress(inspection: Inspection, view: number, name: 'color' | 'depth' | 'level_of_detection' | 'depth_overlay'): string {
  const taken = encodeURIComponent(inspection.initial?.taken_at ?? '');
  return `/api/inspections/${inspection.id}/baseline/${view}/${name}.png?v=${taken}`;
}
