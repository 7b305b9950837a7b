// Generated from schema/api.json by `npm run types`.

/** The version of the protocol between console and server. A console of another version is refused. */
export type Protocol = 1;

export type Stream = 'color' | 'depth' | 'infrared';

export type Role = 'viewer' | 'operator' | 'inspector';

export type SideName = 'initial' | 'final';

/** `done` once a person has closed the inspection. */
export type Stage = 'baseline' | 'work' | 'review' | 'done';

/** `debris` is still there; `debris-unreachable` cannot be reached. */
export type Verdict =
  | 'debris'
  | 'debris-removed'
  | 'debris-unreachable'
  | 'installed-work'
  | 'false-alarm'
  | 'second-look';

/** What a finding is according to the plan of its view. `missing`: a planned part that was not found. */
export type PlannedState = 'unplanned' | 'surplus' | 'planned' | 'missing';

/** Pixels of the baseline's depth image, or metres in the frame of its camera. */
export type PlanCoordinates = 'pixels' | 'metres';

export type FindingKind = 'added' | 'removed' | 'appearance';

export type Evidence = 'depth' | 'appearance';

export type TaskKind = 'readiness' | 'capture' | 'check' | 'comparison' | 'signing';

export type TaskEnd = 'running' | 'done' | 'cancelled' | 'failed';

export type ErrorCode =
  | 'bad-request'
  | 'sign-in-required'
  | 'wrong-password'
  | 'not-allowed'
  | 'wrong-origin'
  | 'not-found'
  | 'method-not-allowed'
  | 'not-json'
  | 'wrong-host'
  | 'refused'
  | 'somebody-drives'
  | 'not-driving'
  | 'too-large'
  | 'too-many'
  | 'internal'
  | 'unavailable';

/** Date and time, ISO 8601. */
export type Moment = string;

/** [x, y, z] in metres. */
export type Point3 = [number, number, number];

/** [least, greatest]. */
export type Range = [number, number];

/** [width, height]. */
export type Extent = [number, number];

/** [u, v] in pixels of the baseline's depth image; the centre of its first pixel is (0, 0). */
export type Corner = [number, number];

/** The last corner is joined with the first. */
export type Polygon = Corner[];

/** [u, v, width, height] in pixels. */
export type Box = [number, number, number, number];

/** The answer to a request that returns nothing. */
export type Empty = Record<string, never>;

export interface ErrorDetail {
  code: ErrorCode;
  /** For people. */
  message: string;
}

export interface ErrorAnswer {
  error: ErrorDetail;
}

export interface Health {
  /** Whether no check has a problem; the status is 200 then, otherwise 503. */
  healthy: boolean;
  checks: HealthCheck[];
}

export interface HealthCheck {
  name: 'camera' | 'robot' | 'data' | 'disk' | 'records';
  healthy: boolean;
  /** What is wrong, and what to do; missing where nothing is. */
  problem?: string;
}

export interface Session {
  protocol: Protocol;
  /** Whether there are accounts. */
  sign_in_needed: boolean;
  /** Of the account; empty if there are no accounts. */
  name?: string;
  /** Missing until somebody has signed in. */
  role?: Role;
}

export interface Joints {
  pan_deg: number;
  tilt_deg: number;
}

/** Parts of one kind, as in a plan file (docs/planned-work.md). */
export interface PlanPart {
  /** Unique in its plan. */
  name: string;
  kind: FindingKind;
  count: number;
  /** Above what they are on; missing for parts that images alone show. */
  height_mm?: Range;
  /** Of their largest extents; missing for any size. */
  size_mm?: Range;
  /** Polygons. */
  areas: PlanPoints[];
  /** The centre of each part; missing where only areas are known. */
  places?: PlanPoints;
  /** How far from its place a part may be. */
  tolerance_mm: number;
}

/** Two pixels or three metres. */
export type PlanPoint = number[];

export type PlanPoints = PlanPoint[];

/** What the work order states will change: a plan file. */
export interface Plan {
  format: 'rva-plan';
  version: 1;
  coordinates: PlanCoordinates;
  parts: PlanPart[];
}

export interface PlanRequest {
  /** A plan file, YAML or JSON; empty removes the plan. */
  text: string;
}

export interface View extends Joints {
  /** Regions left out of the comparison; missing if there are none. */
  ignore?: Polygon[];
  /** Missing if there is none. */
  plan?: Plan;
}

export interface TakenSide {
  taken_at: Moment;
  person: string;
  /** Identifies the position of the robot's foot. */
  base: string;
  round: number;
}

export interface Decision {
  verdict: Verdict;
  note: string;
  person: string;
  decided_at: Moment;
  /** The last complete round of the final side at that time; 0 if there was none, or it is not known. */
  round: number;
  /** What the object is, as the person named it: a class of the classifier or any other name, up to 200 bytes; missing where the person did not. */
  object?: string;
}

export interface Finding {
  /** From the most suspicious to the least. */
  number: number;
  view: number;
  /** The most suspicious finding of the same object in all views, which may be this one. */
  same_as: number;
  kind: FindingKind;
  bbox: Box;
  /** In pixels, as `bbox`. */
  centroid: Corner;
  /** In the frame of the view's camera. */
  position_m?: Point3;
  /** In the frame of the robot's foot, as the map. */
  in_foot_m?: Point3;
  /** Of the box, at the distance of the finding. */
  size_mm?: Extent;
  /** Change of depth. */
  height_mm?: number;
  /** Height above the surface around it: of an added finding after the work, of a removed one before. */
  above_surroundings_mm?: number;
  /** Whether depth changed by much more than that, since a farther surface was seen there before, or is seen now. Only with `above_surroundings_mm` and `height_mm`. */
  background_jump?: boolean;
  /** Height of its top above the surface that it lies on, at right angles to it; missing where that surface is not known. */
  top_above_surroundings_mm?: number;
  /** Whether it may be higher: it is not wholly seen, or the surface around it is seen in part. With `top_above_surroundings_mm`. */
  top_is_least?: boolean;
  /** In how many of its pixels its view shows it clearly: with depth, and within the colour imager's view; 0 at the border of the image. Of the findings of one object, that with the most is in the best view. Missing in comparisons of earlier versions. */
  clear_px?: number;
  score?: number;
  p_value?: number;
  /** Which images show the change. */
  evidence: Evidence[];
  /** The removed finding of about the same size: the object may have been moved. */
  moved_from?: number;
  /** Missing if its view has no plan. */
  planned?: PlannedState;
  /** Name of the part of the plan; missing if it is unplanned. */
  planned_item?: string;
  /** What the classifier calls it, or `unknown`; missing where it was not classified. A hint: it never hides a finding. */
  class?: string;
  /** Of the most probable class, also of an unknown one. */
  probability?: number;
  decision?: Decision;
}

/** A finding that a person marked in a picture. It stays with its inspection through later rounds. */
export interface MarkedFinding {
  /** Among the marked findings of the inspection. */
  number: number;
  /** Missing if it was marked in the live picture. */
  view?: number;
  /** The comparison whose pictures were shown; missing as `view`. */
  comparison?: number;
  /** The last complete round of the final side at that time; 0 if there was none. */
  round: number;
  bbox: Box;
  /** Of the surface in the middle of the box, in the frame of the camera; missing if it was not measured. */
  position_m?: Point3;
  /** In the frame of the robot's foot, as the map. */
  in_foot_m?: Point3;
  /** Of the box, at that distance. */
  size_mm?: Extent;
  note: string;
  person: string;
  marked_at: Moment;
  decision?: Decision;
}

/** A person's statement that an inspection is complete. Nothing can be changed afterwards. */
export interface Closing {
  /** The comparison that the person reviewed. */
  comparison: number;
  person: string;
  note: string;
  closed_at: Moment;
}

/** Shares of the depth image, 0 to 1. */
export interface Coverage {
  /** Measured before and after. */
  compared: number;
  /** Measured after only. */
  unseen: number;
  /** Not measured after. */
  invalid: number;
  /** Left out by the user; missing if nothing was. */
  left_out?: number;
}

export interface FindableShare {
  size_mm: number;
  /** Of the depth image, in which an object of this size and height would have been found, 0 to 1. */
  share: number;
}

/** What a comparison found of one part of a plan: numbers of parts. */
export interface PlannedWork {
  name: string;
  kind: FindingKind;
  planned: number;
  found: number;
  /** Those that would have been found, and were not. */
  missing: number;
  /** The others. */
  not_inspected: number;
}

export interface ComparedView {
  view: number;
  /** As of `rva detect --method`. */
  method: string;
  coverage: Coverage;
  /** Share of the depth image in which a change could have been found, 0 to 1. */
  judged: number;
  warnings: string[];
  /** Small to large; empty if it is not known. */
  findable: FindableShare[];
  /** Missing if the view has no plan. */
  planned?: PlannedWork[];
}

export interface InspectionSummary {
  id: number;
  aircraft: string;
  zone: string;
  work_order: string;
  person: string;
  created_at: Moment;
  stage: Stage;
  /** Findings of the valid comparison, and marked ones. */
  findings_count: number;
  /** Those without a decision, that need a second look, or are debris that is still there. */
  undecided_count: number;
  initial?: TakenSide;
  final?: TakenSide;
  /** Number of the valid comparison. */
  comparison?: number;
  compared_at?: Moment;
  /** Missing until the inspection is closed. */
  closing?: Closing;
  /** There is a signed package. Missing otherwise. */
  has_signature?: true;
}

/** What a comparison showed, also after later ones. */
export interface Round {
  comparison: number;
  compared_at: Moment;
  /** The round of the final side that was compared; missing if it is not known. */
  final?: TakenSide;
  compared: ComparedView[];
  /** Most suspicious first. */
  findings: Finding[];
}

export interface RoundList {
  /** Newest first. */
  rounds: Round[];
}

export interface InspectionList {
  /** Newest first. */
  inspections: InspectionSummary[];
}

/** Numbers of objects by verdict. `left`: debris that is still there; `undecided`: also those that need a second look. */
export interface VerdictCounts {
  removed: number;
  left: number;
  unreachable: number;
  installed: number;
  false_alarms: number;
  undecided: number;
}

/** With its interval of 95 %. */
export interface Ratio {
  value: number;
  low: number;
  high: number;
}

export interface NamedDebris {
  /** As people named it; empty where nobody did. */
  name: string;
  objects: number;
}

/** Sums over inspections. */
export interface Trend {
  inspections: number;
  closed: number;
  /** From the beginning to the closing of those that were closed. Missing where none was. */
  median_hours?: number;
  /** Complete ones, also of those that later ones replaced. */
  comparisons: number;
  /** Objects that the program found, counted anew in each comparison. */
  found: VerdictCounts;
  /** Objects that people marked. */
  marked: VerdictCounts;
  /** Missing without a comparison. */
  false_alarms_per_comparison?: Ratio;
  /** Among the objects that were found and decided on. Missing where there are none. */
  false_alarm_share?: Ratio;
  /** Debris that was found or marked, by name. */
  debris: NamedDebris[];
}

export interface MonthTrend extends Trend {
  month: Month;
}

export interface ZoneTrend extends Trend {
  zone: string;
}

export interface ZoneMonthTrend extends Trend {
  zone: string;
  month: Month;
}

/** In which inspections were begun: `2026-01`, UTC. */
export type Month = string;

export interface Trends {
  sum: Trend;
  /** Of all zones, ascending; those without an inspection are missing. */
  months: MonthTrend[];
  /** Of all months, by name. */
  zones: ZoneTrend[];
  /** By zone, then by month. */
  zone_months: ZoneMonthTrend[];
}

/** `debris` was removed after the last captures, or cannot be reached; `coverage`: less than half of a view was inspected; `lost-item`: an item of the check-out list is lost and was released. */
export type ClosingReason = 'debris' | 'coverage' | 'lost-item';

export interface BegunFinal {
  /** Whether the robot was put back since the baseline. */
  replaced: boolean;
}

export interface Inspection extends InspectionSummary {
  views: View[];
  compared: ComparedView[];
  /** Most suspicious first. */
  findings: Finding[];
  /** Findings that people marked, in any round. */
  marked: MarkedFinding[];
  /** Pictures that people kept. */
  snapshots: Snapshot[];
  /** The check-out list: what was taken into the bay. */
  items: Item[];
  /** Whether a note is needed to close it: `closing_note_for` is not empty. */
  closing_needs_note: boolean;
  /** Why a note is needed to close it. */
  closing_note_for: ClosingReason[];
  /** Its signed packages, in their order. Missing where there are none, and in exported records. */
  signed?: SignedPackage[];
  /** A round of the final side that is not complete. */
  final_begun?: BegunFinal;
}

/** A signed package as its statement describes it; not verified. */
export interface SignedPackage {
  /** Relative to the data folder. */
  folder: string;
  /** Empty if the package cannot be read. */
  signed_at: string;
  /** Public keys (NAME+ID+BASE64), in the order of the signatures; none if the package cannot be read. */
  signers: string[];
}

export type ItemState = 'out' | 'lost' | 'released' | 'back';

/** What a person states of an item. Earlier statements are kept. */
export interface ItemStatement {
  /** How many came out. */
  returned: number;
  /** How many stay in, as installed work, or were consumed. */
  used: number;
  /** How many cannot be found. */
  lost: number;
  /** Whether the person takes the responsibility for those that are lost. */
  released: boolean;
  note: string;
  person: string;
  stated_at: Moment;
}

export interface Item {
  number: number;
  name: string;
  /** Number of a tool; may be empty. */
  identity: string;
  quantity: number;
  person: string;
  taken_at: Moment;
  state: ItemState;
  /** In their order; the last one applies. */
  statements: ItemStatement[];
}

export interface KeyList {
  /** Public keys (NAME+ID+BASE64) of the site: that of its log first, then those of people, earlier ones included. */
  keys: string[];
}

export interface LevelsAtDistance {
  from_m: number;
  to_m: number;
  median_mm: number;
  /** Nine tenths of the pixels have this level or a smaller one. */
  p90_mm: number;
  /** In a baseline check only. */
  pixels?: number;
  /** What is `window_px` wide in the image is as wide as this at `to_m`. Missing in records of earlier versions. */
  width_mm?: number;
}

/** Levels of detection, docs/calibrated.md. */
export interface Levels {
  /** Share of the depth image that has a level, 0 to 1. */
  judged: number;
  /** Width in the image of the objects to which the levels apply. */
  window_px: number;
  /** Near to far. */
  by_distance: LevelsAtDistance[];
  /** Small to large. Missing in baseline checks of earlier versions. */
  findable?: FindableShare[];
}

export interface RecordedLevels extends Levels {
  format: 'rva-level-of-detection';
  version: 1;
  drift_px: number;
  fixed_px: number;
  /** Missing if it could not be estimated. */
  effective_frames?: number;
}

/** With `problem`, or with the result of the comparison. */
export interface CheckedView {
  view: number;
  false_findings?: number;
  level_of_detection?: RecordedLevels;
  /** Why the view cannot be compared. */
  problem?: string;
}

/** The first half of each view's baseline captures compared with the second half. */
export interface BaselineCheck {
  format: 'rva-baseline-check';
  version: 1;
  /** Of each half. */
  captures: number;
  views: CheckedView[];
}

export interface MeasuredPoint {
  /** In the frame of the camera; of a map, in that of the robot's foot. */
  position_m: Point3;
  /** From the camera; of a map, from the view that is nearest to it. */
  distance_m: number;
  /** Expanded. */
  distance_uncertainty_mm?: number;
  /** Another surface is so close that the camera may show that one; the uncertainty does not include this. */
  near_edge?: boolean;
}

export interface FrozenPicture {
  /** Its number; the last eight are kept. */
  frozen: number;
  stream: Stream;
  width: number;
  height: number;
  taken_at: string;
}

/** A live picture that was kept; it is no finding. */
export interface Snapshot {
  number: number;
  note: string;
  person: string;
  taken_at: string;
}

export type MeasureTool = 'distance' | 'length' | 'height' | 'profile';

export interface ProfileSample {
  /** Of the line in the picture, 0 to 1. */
  share: number;
  /** From the first end, along the line; missing in a gap, as the others. */
  along_mm?: number;
  /** Above the line through both ends, towards the camera. */
  height_mm?: number;
  /** Expanded. */
  height_uncertainty_mm?: number;
}

export interface UnmeasuredPart {
  reason: 'outside' | 'no-depth' | 'edge' | 'collinear' | 'no-view';
  part: 'point' | 'line-ends' | 'surface' | 'surface-points';
  /** From 1, where the part is a point. */
  point?: number;
}

/** Uncertainties are expanded: `coverage_factor` times the standard uncertainty. */
export interface Measurement {
  tool?: MeasureTool;
  coverage_factor?: number;
  /** In the order of the request; null where depth is not measured. */
  points: (MeasuredPoint | null)[];
  /** Why something cannot be measured. */
  problem?: string;
  /** The same for programs that state it in their own words. */
  unmeasured?: UnmeasuredPart;
  /** Between two points that are both measured. */
  length_mm?: number;
  length_uncertainty_mm?: number;
  /** Above the plane, positive towards the camera. */
  height_mm?: number;
  height_uncertainty_mm?: number;
  /** In order, both ends included. */
  profile?: ProfileSample[];
  /** Number of depth images that were averaged. */
  frames?: number;
}

export interface SignInRequest {
  name: string;
  password: string;
}

export interface Order {
  aircraft: string;
  zone: string;
  work_order: string;
  person: string;
}

export interface ViewsRequest {
  views: Joints[];
}

export interface RegionsRequest {
  view: number;
  /** Replaces the regions of the view. */
  ignore: Polygon[];
}

export interface CaptureRequest {
  side: SideName;
  person: string;
  /** Whether the robot was put back since the baseline. */
  replaced: boolean;
}

export interface DecisionRequest {
  /** The comparison of which the finding is; refused if another one is valid by now. */
  comparison: number;
  verdict: GivenVerdict;
  note: string;
  /** What the object is, as the person named it: a class of the classifier or any other name, up to 200 bytes; missing where the person did not. */
  object?: string;
  person: string;
}

/** A `Verdict`, or `undecided`, which withdraws the earlier decision: the finding has none then. */
export type GivenVerdict =
  | 'debris'
  | 'debris-removed'
  | 'debris-unreachable'
  | 'installed-work'
  | 'false-alarm'
  | 'second-look'
  | 'undecided';

/** With either `finding` or `mark`. */
export interface GivenDecision {
  /** The number of a finding of the comparison. */
  finding?: number;
  /** The number of a marked finding. */
  mark?: number;
  verdict: GivenVerdict;
  note: string;
  /** What the object is, as the person named it: a class of the classifier or any other name, up to 200 bytes; missing where the person did not. */
  object?: string;
}

/** All of the decisions are recorded, or none. */
export interface DecisionsRequest {
  /** The comparison of which the findings are; refused if another one is valid by now. 0 where there is none. */
  comparison: number;
  decisions: GivenDecision[];
  person: string;
}

/** With `comparison` and `view` in the pictures of the review, with `stream` in the newest live picture. */
export interface MarkRequest {
  /** The comparison whose pictures are shown; refused if another one is valid by now. */
  comparison?: number;
  view?: number;
  stream?: Stream;
  bbox: Box;
  note: string;
  person: string;
}

export interface MarkDecisionRequest {
  verdict: GivenVerdict;
  note: string;
  /** What the object is, as the person named it: a class of the classifier or any other name, up to 200 bytes; missing where the person did not. */
  object?: string;
  person: string;
}

export interface CloseRequest {
  /** The comparison that was reviewed; refused if another one is valid by now. */
  comparison: number;
  note: string;
  person: string;
}

export interface CheckOutRequest {
  /** Items to add: CSV whose first line names the columns item, number and quantity; number and quantity may be left out. */
  csv: string;
  person: string;
}

export interface ItemRequest {
  returned: number;
  used: number;
  lost: number;
  /** By inspectors only, with a note. */
  released: boolean;
  note: string;
  person: string;
}

export interface Signer {
  /** Of an account. */
  name: string;
  password: string;
}

export interface SignRequest {
  /** Of the account that sends the request. */
  password: string;
  /** Further people at this console, all of whom sign the same package. */
  others?: Signer[];
}

/** In pixels of the live picture; the centre of the first pixel is (0, 0). */
export interface Pixel {
  u: number;
  v: number;
}

export interface MeasureRequest {
  stream: Stream;
  /** A picture that was frozen, instead of the live one. */
  frozen?: number;
  /** By default, the distance of one point and the length between two. */
  tool?: MeasureTool;
  /** A distance: one; a length and a profile: two; a height: three of the surface and one above it, or that one alone with `bbox`. */
  points: Pixel[];
  /** Region whose surface a height is above. */
  bbox?: Box;
}

export interface FreezeRequest {
  stream: Stream;
}

/** Of the infrared imagers. It is set for one of the next frames. */
export interface ExposureRequest {
  /** Whether the camera chooses time and gain. */
  automatic: boolean;
  /** Microseconds, within the camera's range; not needed if automatic. */
  time_us?: number;
  /** In the manufacturer's unit; as time_us. */
  gain?: number;
}

export interface LampRequest {
  /** Brightness; 0 switches the lamp off. */
  percent: number;
}

export interface SnapshotRequest {
  stream: Stream;
  /** The picture that was frozen; without it, the newest of the stream. */
  frozen?: number;
  note: string;
  person: string;
}

export interface ViewMeasureRequest {
  /** Whether in the picture before or after the work. */
  side: SideName;
  tool: MeasureTool;
  /** As of `MeasureRequest`, in pixels of the view's pictures. */
  points: Pixel[];
  /** As of `MeasureRequest`. */
  bbox?: Box;
}

export interface MapMeasureRequest {
  /** Points of the map, in the frame of the robot's foot. */
  points_m: [Point3, Point3];
}

export interface SimulationRequest {
  /** Whether the simulated work is done. */
  done: boolean;
}

export interface Hello {
  type: 'hello';
  protocol: Protocol;
  /** Random and secret; identifies the console. */
  client: string;
  name: string;
}

export interface Watch {
  type: 'watch';
  stream: Stream | 'none';
}

/** A point of a picture, as shares of its width and height. */
export interface PictureShare {
  x: number;
  y: number;
}

export type PointingShape = 'tap' | 'arrow' | 'circle';

/** Points at something in the live picture, for all consoles; three a second at most. */
export interface Pointing {
  type: 'pointing';
  stream: Stream;
  shape: PointingShape;
  /** Of an arrow its beginning, of a circle a corner of its box. */
  from: PictureShare;
  /** The tip, or the opposite corner; of a tap, it is not used. */
  to: PictureShare;
}

/** The last picture is shown, and another may be sent. */
export interface Shown {
  type: 'shown';
}

export interface Drive {
  type: 'drive';
  /** Deflection of the sticks, -1 to 1; positive is to the left. */
  pan: number;
  /** -1 to 1; positive is up. */
  tilt: number;
  /** By the console's own clock. */
  stamp_ms: number;
}

export interface LeaseRequest {
  type: 'lease';
  action: 'take' | 'take-over' | 'release';
  /** Not needed to release. */
  name?: string;
}

export interface Stop {
  type: 'stop';
}

export type ClientMessage = Hello | Watch | Shown | Drive | LeaseRequest | Stop | Pointing;

/** Of the infrared imagers, as read back from the camera. */
export interface ExposureStatus {
  /** Whether the camera chooses time and gain. */
  automatic: boolean;
  /** Microseconds. */
  time_us: number;
  /** In the manufacturer's unit. */
  gain: number;
  time_range_us: Range;
  gain_range: Range;
}

export interface CameraStatus {
  /** Frames a second. */
  rate_hz: number;
  /** Frames lost. */
  lost: number;
  problem?: string;
  streams: Stream[];
  /** Missing, as width and height, before the first frame. */
  model?: string;
  /** Of the depth image, in pixels. */
  width?: number;
  /** In pixels. */
  height?: number;
  /** Missing if it cannot be set. */
  exposure?: ExposureStatus;
}

export interface JointLimits {
  pan_deg: Range;
  tilt_deg: Range;
}

export interface RobotStatus {
  driving: boolean;
  /** False after a stop, until all sticks are released. */
  armed: boolean;
  /** Moved automatically, for captures. */
  lent: boolean;
  at_limit: boolean;
  /** Missing, as `tilt_deg`, while the servos do not answer. */
  pan_deg?: number;
  tilt_deg?: number;
  problem?: string;
  limits: JointLimits;
  lamp?: LampStatus;
}

/** Of the lamp around the camera; missing where the robot has none. */
export interface LampStatus {
  /** Brightness; 0 is off. */
  percent: number;
  /** Temperature of the lamp; missing where it is simulated. */
  celsius?: number;
  /** It was switched off, and stays off until it has cooled down. */
  too_hot: boolean;
}

export interface Noise {
  frames: number;
  /** Share of the depth image that is measured, 0 to 1. */
  measured: number;
  /** Median over the pixels of the standard deviation over time; 0 if unknown. */
  median_std_mm: number;
  findable: Levels;
}

export interface TaskStatus {
  /** From 1 since the program started; 0: there was no task yet. */
  number: number;
  kind: TaskKind;
  end: TaskEnd;
  /** Missing if the task does not belong to an inspection. */
  inspection?: number;
  side: SideName;
  /** Under way, from 0, as `capture` and `frame`. */
  view: number;
  views: number;
  capture: number;
  /** Of each view. */
  captures: number;
  frame: number;
  /** Of each capture. */
  frames: number;
  /** To the baseline's pose, from 0. */
  approach: number;
  /** At most. */
  approaches: number;
  /** Steps of `total`, for tasks other than captures. */
  done: number;
  total: number;
  /** Why the task waits for a device. */
  waiting?: string;
  /** Why the task failed. */
  problem?: string;
  /** Of the view under way, or of the last one. */
  noise?: Noise;
}

/** What was measured; `measured` is a share, 0 to 1. */
export interface ReadinessValues {
  width_px?: number;
  height_px?: number;
  rate_hz?: number;
  repeated_frames?: number;
  frames?: number;
  measured?: number;
  drift_mm?: number;
  duration_s?: number;
  pan_deg?: number;
  tilt_deg?: number;
  free_gb?: number;
  least_free_gb?: number;
}

export interface ReadinessItem {
  name: string;
  ready: boolean;
  /** What was measured and, if it is not enough, what to do. */
  says: string;
  /** The same for programs that state it in their own words, with `values`. */
  code: 'camera-ready' | 'camera-slow' | 'camera-frozen' | 'camera-failed' | 'depth-ready' | 'depth-missing' | 'camera-stable' | 'camera-drifting' | 'robot-none' | 'robot-ready' | 'robot-unknown' | 'robot-failed' | 'disk-ready' | 'disk-full' | 'disk-unknown';
  values: ReadinessValues;
}

export interface Readiness {
  /** Whether all items are. */
  ready: boolean;
  checked_at: Moment;
  items: ReadinessItem[];
}

export interface Status {
  type: 'status';
  camera: CameraStatus;
  /** Missing if there is no robot. */
  robot?: RobotStatus;
  task: TaskStatus;
  readiness?: Readiness;
  /** How many are connected. */
  consoles: number;
  /** Whether the bay is simulated. */
  simulation: boolean;
}

export interface Lease {
  type: 'lease';
  yours: boolean;
  /** The name of the driver; missing if nobody drives. */
  holder?: string;
}

/** The refusal of a message. */
export interface Refused {
  type: 'refused';
  code: ErrorCode;
  message: string;
}

/** Somebody points at something in the live picture. It is shown for some seconds, and not stored. */
export interface Pointed {
  type: 'pointed';
  /** Of the account, or as the console's `hello` stated it. */
  name: string;
  stream: Stream;
  shape: PointingShape;
  from: PictureShare;
  to: PictureShare;
}

export type ServerMessage = Status | Lease | Pointed | Refused;

/** The description of a picture at the beginning of a binary message. */
export interface PictureHead {
  stream: Stream;
  /** Of the frame. */
  number: number;
  /** In pixels. */
  width: number;
  /** In pixels. */
  height: number;
  /** Since 1970, by the clock of the robot's computer. */
  taken_ms: number;
  /** Depths of the first and the last colour; of depth pictures only. */
  scale_m?: Range;
}
