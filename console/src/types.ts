// What the server says (docs/api.md).

export type Stream = 'color' | 'depth' | 'infrared';
export type Role = 'viewer' | 'operator' | 'inspector';
export type SideName = 'initial' | 'final';
export type Stage = 'baseline' | 'work' | 'review' | 'done';
export type Verdict = 'debris-removed' | 'installed-work' | 'false-alarm' | 'second-look';
export type Point3 = [number, number, number];

export interface Session {
  protocol: number;
  sign_in_needed: boolean;
  name?: string;
  role?: Role;
}

export interface Joints {
  pan_deg: number;
  tilt_deg: number;
}

/** [u, v] in pixels of the baseline's depth image; the centre of its first pixel is (0, 0). */
export type Corner = [number, number];
/** At least three corners; the last is joined with the first. */
export type Polygon = Corner[];

export interface View extends Joints {
  /** What a person leaves out of the comparison. */
  ignore?: Polygon[];
}

export interface RobotStatus extends Partial<Joints> {
  driving: boolean;
  armed: boolean;
  lent: boolean;
  at_limit: boolean;
  problem?: string;
  limits: { pan_deg: [number, number]; tilt_deg: [number, number] };
}

export interface CameraStatus {
  rate_hz: number;
  lost: number;
  problem?: string;
  streams: Stream[];
  model?: string;
  width?: number;
  height?: number;
}

export interface Levels {
  judged: number;
  window_px: number;
  by_distance: { from_m: number; to_m: number; median_mm: number; p90_mm: number }[];
}

/** One half of each view's baseline compared with the other half. */
export interface BaselineCheck {
  captures: number;
  views: { view: number; false_findings?: number; level_of_detection?: Levels; problem?: string }[];
}

export interface TaskStatus {
  number: number;
  kind: 'readiness' | 'capture' | 'check' | 'comparison';
  end: 'running' | 'done' | 'cancelled' | 'failed';
  inspection?: number;
  side: SideName;
  view: number;
  views: number;
  capture: number;
  captures: number;
  frame: number;
  frames: number;
  approach: number;
  approaches: number;
  done: number;
  total: number;
  waiting?: string;
  problem?: string;
  noise?: { frames: number; measured: number; median_std_mm: number; findable: Levels };
}

export interface Readiness {
  ready: boolean;
  checked_at: string;
  items: { name: string; ready: boolean; says: string }[];
}

export interface Status {
  type: 'status';
  camera: CameraStatus;
  robot?: RobotStatus;
  task: TaskStatus;
  readiness?: Readiness;
  consoles: number;
  simulation: boolean;
}

export interface Lease {
  type: 'lease';
  yours: boolean;
  holder?: string;
}

export interface Refused {
  type: 'refused';
  code: string;
  message: string;
}

export interface PictureHead {
  stream: Stream;
  number: number;
  width: number;
  height: number;
  taken_ms: number;
  scale_m?: [number, number];
}

export interface TakenSide {
  taken_at: string;
  person: string;
  base: string;
}

export interface Decision {
  verdict: Verdict;
  note: string;
  person: string;
  decided_at: string;
}

export type FindingKind = 'added' | 'removed' | 'appearance';

export interface Finding {
  number: number;
  view: number;
  same_as: number;
  kind: FindingKind;
  /** What speaks for it: depth, infrared or colour images that look different, or both. */
  evidence?: ('depth' | 'appearance')[];
  bbox: [number, number, number, number];
  centroid: [number, number];
  position_m?: Point3;
  in_foot_m?: Point3;
  size_mm?: [number, number];
  height_mm?: number;
  score?: number;
  p_value?: number;
  /** Number of the removed finding that has about the size of this one: the object may have been moved. */
  moved_from?: number;
  decision?: Decision;
}

export interface ComparedView {
  view: number;
  method: string;
  /** Shares of the depth image; `left_out` is there when a person left something out. */
  coverage: { compared: number; unseen: number; invalid: number; left_out?: number };
  judged: number;
  warnings: string[];
}

export interface InspectionSummary {
  id: number;
  aircraft: string;
  zone: string;
  work_order: string;
  person: string;
  created_at: string;
  stage: Stage;
  findings_count: number;
  undecided_count: number;
  initial?: TakenSide;
  final?: TakenSide;
  comparison?: number;
  compared_at?: string;
}

export interface Inspection extends InspectionSummary {
  views: View[];
  compared: ComparedView[];
  findings: Finding[];
  /** Of a final capture that was interrupted: what was said of the robot then. */
  final_begun?: { replaced: boolean };
}

export interface MeasuredPoint {
  position_m: Point3;
  distance_m: number;
}

export interface Measurement {
  points: (MeasuredPoint | null)[];
  length_mm?: number;
}
