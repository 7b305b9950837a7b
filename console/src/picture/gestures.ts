// What fingers and the mouse do to a picture. Positions are fractions of the frame.
import type { Size } from '../regions/shapes';
import { pulled, type Point, type Zoom } from './zoom';

export interface Handlers {
  /** The frame's size on the screen. */
  size: () => Size;
  zoom: () => Zoom;
  setZoom: (zoom: Zoom) => void;
  /** Whether one finger draws a rectangle instead of moving the picture. */
  draws: () => boolean;
  tap: (at: Point) => void;
  doubleTap: (at: Point) => void;
  /** A rectangle is drawn; `done` with its last corner. A tap draws one without an extent. */
  draw: (from: Point, to: Point, done: boolean) => void;
  /** The rectangle was not meant: a second finger followed. */
  drop: () => void;
}

interface Contact {
  from: Point;
  to: Point;
}

/** How far a tap may slip, also with a glove, and how far and how late the second one of a double tap may be. */
const glove_px = 10;
const again_px = 40;
const again_ms = 300;

function between(a: Point, b: Point): Point {
  return { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 };
}

export class Gestures {
  private readonly contacts = new Map<number, Contact>();
  private start: Zoom;
  /** Whether this is more than a tap. */
  private far = false;
  private pinching = false;
  private tapped: { at: Point; timer: ReturnType<typeof setTimeout> } | null = null;

  constructor(private readonly on: Handlers) {
    this.start = on.zoom();
  }

  press(id: number, at: Point): void {
    if (this.contacts.size === 2) return;
    this.far = this.contacts.size === 1;
    this.contacts.set(id, { from: at, to: at });
    if (this.contacts.size === 2) {
      this.pinching = true;
      this.on.drop();
    }
    this.restart();
  }

  move(id: number, at: Point): void {
    const contact = this.contacts.get(id);
    if (!contact) return;
    contact.to = at;
    this.far ||= this.distance(contact.from, at) > glove_px;
    if (!this.far) return;
    if (!this.pinching && this.on.draws()) this.on.draw(contact.from, at, false);
    else this.pull();
  }

  release(id: number): void {
    const contact = this.contacts.get(id);
    if (!contact) return;
    this.contacts.delete(id);
    if (this.contacts.size > 0) return this.restart();
    const pinched = this.pinching;
    this.pinching = false;
    if (pinched) return;
    if (!this.far) this.tap(contact.from);
    else if (this.on.draws()) this.on.draw(contact.from, contact.to, true);
  }

  /** The system has taken the pointer away. */
  cancel(id: number): void {
    this.contacts.delete(id);
    this.pinching = this.contacts.size > 0;
    this.on.drop();
    this.restart();
  }

  private restart(): void {
    this.start = this.on.zoom();
    for (const contact of this.contacts.values()) contact.from = contact.to;
  }

  private pull(): void {
    const [one, other] = [...this.contacts.values()];
    if (!one) return;
    if (!other) return this.on.setZoom(pulled(this.start, one.from, one.to));
    const least_px = 20;
    const spread = (a: Point, b: Point) => Math.max(least_px, this.distance(a, b));
    const times = spread(one.to, other.to) / spread(one.from, other.from);
    this.on.setZoom(pulled(this.start, between(one.from, other.from), between(one.to, other.to), times));
  }

  // A single tap takes effect once no second one can follow; while a rectangle is drawn, at once.
  private tap(at: Point): void {
    const before = this.tapped;
    if (before) {
      clearTimeout(before.timer);
      this.tapped = null;
      if (this.distance(before.at, at) < again_px) return this.on.doubleTap(at);
      this.on.tap(before.at);
    }
    if (this.on.draws()) return this.on.draw(at, at, true);
    const timer = setTimeout(() => {
      this.tapped = null;
      this.on.tap(at);
    }, again_ms);
    this.tapped = { at, timer };
  }

  private distance(a: Point, b: Point): number {
    const { width, height } = this.on.size();
    return Math.hypot((a.x - b.x) * width, (a.y - b.y) * height);
  }
}
