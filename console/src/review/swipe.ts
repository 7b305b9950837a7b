// A swipe of a finger to the left or the right. Up and down scrolls, as everywhere.
import type { TargetedPointerEvent } from 'preact';
import { useRef, useState } from 'preact/hooks';

export type Direction = 'left' | 'right';

/** From where on a movement is a swipe, which is then followed, and how far it goes until it counts. */
const least_px = 16;
const far_share = 0.35;

/** The direction of a movement across a card of this width; empty unless it went far enough, and mostly sideways. */
export function swipeOf(dx_px: number, dy_px: number, width_px: number): Direction | '' {
  if (Math.abs(dx_px) < far_share * width_px || Math.abs(dx_px) < 2 * Math.abs(dy_px)) return '';
  return dx_px > 0 ? 'right' : 'left';
}

interface Start {
  id: number;
  x: number;
  y: number;
  swiping: boolean;
}

export interface Swipe {
  /** How far the card is moved; 0 at rest. */
  offset_px: number;
  /** What happens if the finger is lifted now. */
  direction: Direction | '';
  handlers: Record<'onPointerDown' | 'onPointerMove' | 'onPointerUp' | 'onPointerCancel', (event: TargetedPointerEvent<HTMLElement>) => void>;
}

export function useSwipe(enabled: boolean, onSwipe: (direction: Direction) => void): Swipe {
  const start = useRef<Start | null>(null);
  const [moved, setMoved] = useState({ offset_px: 0, direction: '' as Direction | '' });
  const end = () => {
    start.current = null;
    setMoved({ offset_px: 0, direction: '' });
  };
  const press = (event: TargetedPointerEvent<HTMLElement>) => {
    if (start.current) return end(); // a second finger
    const writes = event.target instanceof Element && event.target.closest('textarea, input') !== null;
    if (enabled && event.pointerType !== 'mouse' && !writes) start.current = { id: event.pointerId, x: event.clientX, y: event.clientY, swiping: false };
  };
  const move = (event: TargetedPointerEvent<HTMLElement>) => {
    const from = start.current;
    if (!from || from.id !== event.pointerId) return;
    const [dx_px, dy_px] = [event.clientX - from.x, event.clientY - from.y];
    if (!from.swiping && (Math.abs(dx_px) < least_px || Math.abs(dx_px) < 2 * Math.abs(dy_px))) return;
    // The card gets the rest of the movement, so that no button in it is pressed at its end.
    if (!from.swiping) event.currentTarget.setPointerCapture(event.pointerId);
    from.swiping = true;
    setMoved({ offset_px: dx_px, direction: swipeOf(dx_px, dy_px, event.currentTarget.clientWidth) });
  };
  const release = (event: TargetedPointerEvent<HTMLElement>) => {
    const from = start.current;
    if (!from || from.id !== event.pointerId) return;
    const direction = from.swiping ? swipeOf(event.clientX - from.x, event.clientY - from.y, event.currentTarget.clientWidth) : '';
    end();
    if (direction !== '') onSwipe(direction);
  };
  return { ...moved, handlers: { onPointerDown: press, onPointerMove: move, onPointerUp: release, onPointerCancel: end } };
}
