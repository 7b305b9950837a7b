// Marks something in a picture that the program did not find: by a tap, by drawing a rectangle, or by keyboard.
import type { ComponentChildren } from 'preact';
import { useEffect, useLayoutEffect, useRef, useState } from 'preact/hooks';
import type { Size } from '../regions/shapes';
import type { Store } from '../store';
import type { Box, Pixel } from '../types';
import { words } from '../words/words';
import { boxInMiddle, movedBox, resizedBox } from './marks';
import { shownPart, type Zoom } from './zoom';
import type { Frame } from './ZoomPicture';

/** Where a finger was put down, and where it was lifted. */
export type Line = [Pixel, Pixel];

/** The state of marking, for the parts below and for `ZoomPicture`. */
export interface Marking {
  /** Whether a tap or a drag marks instead of moving or measuring. */
  active: boolean;
  /** A box that is not confirmed yet: one that is being drawn, or that is moved by keys. */
  draft: Box | null;
  /** Whether the draft is moved by keys and waits for a confirmation. */
  byKeys: boolean;
  begin: () => void;
  leave: () => void;
  setDraft: (draft: Box | null, byKeys?: boolean) => void;
  /** Ends marking with this box, and the way that the finger took, if it drew one. */
  finish: (box: Box, line?: Line) => void;
}

/**
 * @param onMark called with a box of whole pixels of the picture; undefined where nothing can be marked, which also
 *   hides `MarkButton`
 */
export function useMarking(onMark: ((box: Box, line?: Line) => void) | undefined): Marking {
  const [active, setActive] = useState(false);
  const [{ draft, byKeys }, setState] = useState<{ draft: Box | null; byKeys: boolean }>({ draft: null, byKeys: false });
  const setDraft = (next: Box | null, keys = false) => setState({ draft: next, byKeys: keys });
  const leave = () => {
    setActive(false);
    setDraft(null);
  };
  // Escape also stops the robot, whatever else it does.
  useLayoutEffect(() => {
    if (!active) return;
    const press = (event: KeyboardEvent) => event.key === 'Escape' && leave();
    window.addEventListener('keydown', press);
    return () => window.removeEventListener('keydown', press);
  }, [active]);
  const finish = (box: Box, line?: Line) => {
    leave();
    onMark?.(box, line);
  };
  return { active: active && onMark !== undefined, draft, byKeys, begin: () => setActive(true), leave, setDraft, finish };
}

/** Starts marking; belongs in the bar above a picture. */
export function MarkButton({ marking, shown }: { marking: Marking; shown: boolean }) {
  if (!shown) return null;
  return (
    <button type="button" aria-label={words.picture.markAFinding} data-testid="mark" onClick={marking.begin}>
      {words.picture.mark}
    </button>
  );
}

interface BarProps {
  marking: Marking;
  size: Size;
  zoom: Store<Zoom>;
  /** What to do, and what its buttons do; by default that something is marked. */
  texts?: typeof words.live.pointTexts;
  /** Further choices. */
  children?: ComponentChildren;
}

/** Takes the place of the bar above the picture while something is marked. */
export function MarkBar({ marking, size, zoom, texts, children }: BarProps) {
  const { guide, middle, confirm, leave } = texts ?? words.picture.markTexts;
  const { draft, byKeys } = marking;
  const begin = () => marking.setDraft(boxInMiddle(shownPart(zoom.value, size), size), true);
  return (
    <div class="view-bar" data-testid="mark-bar">
      <span class="mark-guide" role="status">
        {byKeys ? words.picture.guideByKeys : guide}
      </span>
      {byKeys && draft ? (
        <button type="button" class="primary" data-testid="mark-confirm" onClick={() => marking.finish(draft)}>
          {confirm}
        </button>
      ) : (
        <button type="button" data-testid="mark-middle" onClick={begin}>
          {middle}
        </button>
      )}
      {children}
      <button type="button" data-testid="mark-leave" onClick={marking.leave}>
        {leave}
      </button>
    </div>
  );
}

const directions: Record<string, [number, number]> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

/** The box that is being marked, over the picture. */
export function MarkBox({ marking, frame, size }: { marking: Marking; frame: Frame; size: Size }) {
  const { draft, byKeys } = marking;
  const group = useRef<SVGGElement>(null);
  useEffect(() => {
    if (byKeys) group.current?.focus();
  }, [byKeys]);
  if (!draft) return null;
  const pressKey = (event: KeyboardEvent) => {
    const direction = directions[event.key];
    if (!byKeys || event.ctrlKey || event.altKey || event.metaKey || (!direction && event.key !== 'Enter')) return;
    event.preventDefault();
    event.stopPropagation();
    if (!direction) return marking.finish(draft);
    const change = event.shiftKey ? resizedBox : movedBox;
    const step_px = Math.max(1, Math.round(8 * frame.screen_px));
    marking.setDraft(change(draft, size, step_px * direction[0], step_px * direction[1]), true);
  };
  const [x, y, width, height] = draft;
  return (
    <svg class="overlay" viewBox={frame.viewBox}>
      <g
        ref={group}
        class="mark-box"
        role="button"
        tabindex={byKeys ? 0 : -1}
        aria-label={words.picture.box}
        data-testid="mark-box"
        data-box={draft.join(' ')}
        onKeyDown={pressKey}
      >
        <rect class="halo" x={x} y={y} width={width} height={height} />
        <rect class="outline" x={x} y={y} width={width} height={height} />
      </g>
    </svg>
  );
}
