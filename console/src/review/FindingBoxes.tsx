// Findings as outlines over a picture. They and their labels stay outside of what was found and keep their size on
// the screen; when a finding fills the frame, its outline fades.
import type { Frame } from '../picture/ZoomPicture';
import { signOf } from '../inspection/words';
import type { Finding, Pixel } from '../types';

export interface Marked {
  finding: Finding;
  label: number;
  selected: boolean;
  /** Whether nothing remains to be decided about it. */
  settled: boolean;
}

/** The distance of an outline from its finding, and how far from it a tap still counts, in pixels of the screen. */
const gap_px = 6;
const touch_px = 24;
/** An outline fades when its finding takes up more than this share of the frame. */
const close_share = 0.25;

function isClose({ bbox }: Finding, { shown: [, , width, height] }: Frame): boolean {
  return bbox[2] > close_share * width || bbox[3] > close_share * height;
}

function FindingBox({ marked: { finding, label, selected, settled }, frame }: { marked: Marked; frame: Frame }) {
  const [u, v, width, height] = finding.bbox;
  const gap = gap_px * frame.screen_px;
  const outline = { x: u - gap, y: v - gap, width: width + 2 * gap, height: height + 2 * gap, rx: 4 * frame.screen_px };
  const text_px = 18;
  // Above the box, or below it where there is no room.
  const above = v - gap - 1.5 * text_px * frame.screen_px > frame.shown[1];
  return (
    <g class={`finding-box ${finding.planned === 'missing' ? 'missing' : finding.kind} ${selected ? 'selected' : ''} ${settled ? 'settled' : ''} ${isClose(finding, frame) ? 'close' : ''}`} data-testid={`box-${finding.number}`}>
      <rect class="halo" {...outline} />
      <rect class="outline" {...outline} />
      <text x={u - gap} y={above ? v - gap - 7 * frame.screen_px : v + height + gap + text_px * frame.screen_px} font-size={text_px * frame.screen_px} stroke-width={4 * frame.screen_px}>
        {`${settled ? '✓ ' : ''}${label} ${finding.number < 0 ? '✎' : signOf(finding)}`}
      </text>
    </g>
  );
}

export function FindingBoxes({ marked, frame }: { marked: Marked[]; frame: Frame }) {
  return (
    <svg class="overlay" viewBox={frame.viewBox} data-testid="boxes">
      {marked.map((one) => (
        <FindingBox key={one.finding.number} marked={one} frame={frame} />
      ))}
    </svg>
  );
}

// Outside of a box; 0 within it.
function distanceTo([u, v, width, height]: Finding['bbox'], at: Pixel): number {
  return Math.hypot(Math.max(u - at.u, 0, at.u - u - width), Math.max(v - at.v, 0, at.v - v - height));
}

/** The finding that a tap means: the nearest one within reach of a glove, and of several the smallest. */
export function findingAt(marked: Marked[], at: Pixel, screen_px: number): Marked | undefined {
  const near = marked
    .map((one) => ({ one, distance: distanceTo(one.finding.bbox, at), area: one.finding.bbox[2] * one.finding.bbox[3] }))
    .filter(({ distance }) => distance <= touch_px * screen_px);
  return near.sort((a, b) => a.distance - b.distance || a.area - b.area)[0]?.one;
}
