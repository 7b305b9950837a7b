// A picture that is enlarged and moved by fingers, mouse or keyboard, with drawings over it.
import './zoom.css';
import type { ComponentChildren, TargetedMouseEvent, TargetedPointerEvent, TargetedWheelEvent } from 'preact';
import { useEffect, useRef, useState } from 'preact/hooks';
import type { Size } from '../regions/shapes';
import { useStore, type Store } from '../store';
import type { Box, Pixel } from '../types';
import { Gestures, type Handlers } from './gestures';
import { MarkBox, type Marking } from './marking';
import { boxAround, boxBetween } from './marks';
import { double_tap, inPicture, panned, shownPart, step, whole, zoomed, zoomedAbout, type Point, type Zoom } from './zoom';

/** What the frame shows, for drawings that keep their size on the screen while the picture is enlarged. */
export interface Frame {
  /** The visible part of the picture, in its pixels, for an SVG image that fills the frame. */
  viewBox: string;
  /** The same part: [u, v, width, height]. */
  shown: Box;
  /** The size of a pixel of the screen, in pixels of the picture. */
  screen_px: number;
}

interface Props {
  /** Of the picture, in its pixels. */
  size: Size;
  /** Kept by the caller, so that other pictures of the same scene are shown with it, too. */
  zoom: Store<Zoom>;
  /** The picture's name for screen readers. */
  label: string;
  /** The pictures, upon each other; each fills the frame. */
  children: ComponentChildren;
  /** Drawn over the pictures, not enlarged with them. */
  overlay?: (frame: Frame) => ComponentChildren;
  /** Fixed in the frame: captions, scales, messages. */
  fixed?: ComponentChildren;
  /** A tap that is not a double tap. */
  onTap?: (at: Pixel, frame: Frame) => void;
  /** While it is active, a tap or a drag with one finger marks a box. */
  marking?: Marking;
}

interface Latest<T> {
  current: T;
}

/** How much the wheel enlarges, as a logarithm; a browser may report lines instead of pixels. */
const wheel_per_px = 0.002;
const line_px = 30;
/** How far an arrow key moves the picture, in fractions of the frame. */
const pan = 0.15;

function changeByKey(key: string, zoom: Zoom): Zoom | null {
  if (key === '+' || key === '=') return zoomed(zoom, step);
  if (key === '-') return zoomed(zoom, 1 / step);
  if (key === '0') return whole;
  if (zoom.scale === 1) return null;
  const arrows: Record<string, [number, number]> = { ArrowLeft: [-pan, 0], ArrowRight: [pan, 0], ArrowUp: [0, -pan], ArrowDown: [0, pan] };
  const arrow = arrows[key];
  return arrow ? panned(zoom, ...arrow) : null;
}

function useWidth(frame: Latest<HTMLDivElement | null>): number {
  const [width, setWidth] = useState(0);
  useEffect(() => {
    if (!frame.current) return;
    const observer = new ResizeObserver(([entry]) => setWidth(entry?.contentRect.width ?? 0));
    observer.observe(frame.current);
    return () => observer.disconnect();
  }, []);
  return width;
}

function placeOf(event: TargetedMouseEvent<HTMLDivElement>): Point {
  const box = event.currentTarget.getBoundingClientRect();
  return { x: (event.clientX - box.left) / box.width, y: (event.clientY - box.top) / box.height };
}

function turnWheel(event: TargetedWheelEvent<HTMLDivElement>, zoom: Store<Zoom>): void {
  event.preventDefault();
  const px = event.deltaMode === WheelEvent.DOM_DELTA_PIXEL ? event.deltaY : line_px * event.deltaY;
  zoom.value = zoomedAbout(zoom.value, placeOf(event), Math.exp(-px * wheel_per_px));
}

// A key that changes the picture does not turn the camera as well, which arrow keys do elsewhere.
function pressKey(event: KeyboardEvent, zoom: Store<Zoom>): void {
  if (event.ctrlKey || event.altKey || event.metaKey) return;
  const next = changeByKey(event.key, zoom.value);
  if (!next) return;
  event.preventDefault();
  event.stopPropagation();
  zoom.value = next;
}

export function ZoomPicture(props: Props) {
  const { size, label, children, overlay, fixed, marking } = props;
  const element = useRef<HTMLDivElement>(null);
  const zoom = useStore(props.zoom);
  const width = useWidth(element);
  const latest = useRef(props);
  latest.current = props;
  const shown = shownPart(zoom, size);
  const frame: Frame = {
    viewBox: shown.join(' '),
    shown,
    screen_px: size.width / zoom.scale / (width || size.width),
  };
  const latestFrame = useRef(frame);
  latestFrame.current = frame;

  const gestures = useRef<Gestures | null>(null);
  gestures.current ??= new Gestures(handlersOf(latest, latestFrame, element));
  const act = gestures.current;
  const press = (event: TargetedPointerEvent<HTMLDivElement>) => {
    if (event.button !== 0) return;
    event.currentTarget.setPointerCapture(event.pointerId);
    act.press(event.pointerId, placeOf(event));
  };
  return (
    <div class="picture">
      <div class="picture-fit" style={{ aspectRatio: `${size.width} / ${size.height}`, '--shape': size.width / size.height }}>
        <div
          ref={element}
          class={`zoom-frame ${zoom.scale > 1 ? 'enlarged' : ''} ${marking?.active ? 'marking' : ''}`}
          role="group"
          tabIndex={0}
          aria-label={label}
          aria-keyshortcuts="+ - 0"
          data-testid="picture"
          data-scale={zoom.scale.toFixed(2)}
          onPointerDown={press}
          onPointerMove={(event) => act.move(event.pointerId, placeOf(event))}
          onPointerUp={(event) => act.release(event.pointerId)}
          onPointerCancel={(event) => act.cancel(event.pointerId)}
          onWheel={(event) => turnWheel(event, props.zoom)}
          onKeyDown={(event) => pressKey(event, props.zoom)}
        >
          <div class="zoom-layers" style={{ transform: `scale(${zoom.scale}) translate(${-100 * zoom.left}%, ${-100 * zoom.top}%)` }}>
            {children}
          </div>
          {overlay?.(frame)}
          {marking?.active && <MarkBox marking={marking} frame={frame} size={size} />}
        </div>
        {fixed}
      </div>
    </div>
  );
}

function handlersOf(props: Latest<Props>, frame: Latest<Frame>, element: Latest<HTMLDivElement | null>): Handlers {
  const store = () => props.current.zoom;
  const marking = () => props.current.marking;
  const pixelOf = (at: Point): Pixel => {
    const { x, y } = inPicture(store().value, at);
    return { u: x * props.current.size.width - 0.5, v: y * props.current.size.height - 0.5 };
  };
  return {
    size: () => element.current?.getBoundingClientRect() ?? { width: 1, height: 1 },
    zoom: () => store().value,
    setZoom: (zoom) => (store().value = zoom),
    draws: () => marking()?.active ?? false,
    tap: (at) => props.current.onTap?.(pixelOf(at), frame.current),
    doubleTap: (at) => (store().value = store().value.scale > 1 ? whole : zoomedAbout(whole, at, double_tap)),
    draw: (from, to, done) => {
      const { size } = props.current;
      const box = from === to ? boxAround(pixelOf(from), size) : boxBetween(pixelOf(from), pixelOf(to), size);
      if (done) marking()?.finish(box, from === to ? undefined : [pixelOf(from), pixelOf(to)]);
      else marking()?.setDraft(box);
    },
    drop: () => {
      if (marking()?.draft && !marking()?.byKeys) marking()?.setDraft(null);
    },
  };
}
