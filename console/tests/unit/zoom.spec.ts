// Which part of a picture is shown, and what fingers do to it. Without a browser.
import { expect, test } from '@playwright/test';
import { Gestures, type Handlers } from '../../src/picture/gestures';
import { centredOn, closeTo, inPicture, most, panned, pulled, whole, zoomed, zoomedAbout, type Point, type Zoom } from '../../src/picture/zoom';

const places: Point[] = [{ x: 0, y: 0 }, { x: 0.3, y: 0.8 }, { x: 0.5, y: 0.5 }, { x: 1, y: 1 }];
const zooms: Zoom[] = [whole, { scale: 2, left: 0.1, top: 0.4 }, { scale: 7, left: 6 / 7, top: 0 }];

function isWithin({ scale, left, top }: Zoom): boolean {
  return scale >= 1 && scale <= most && [left, top].every((start) => start >= 0 && start + 1 / scale <= 1 + 1e-12);
}

function expectSame(one: Point, other: Point): void {
  expect(one.x).toBeCloseTo(other.x, 12);
  expect(one.y).toBeCloseTo(other.y, 12);
}

test('enlarging about a point leaves that point where it is', () => {
  for (const zoom of zooms)
    for (const at of places) for (const times of [1, 1.2, 5, 100]) expectSame(inPicture(zoomedAbout(zoom, at, times), at), inPicture(zoom, at));
});

test('the picture never leaves its frame', () => {
  const pulls = zooms.flatMap((zoom) => places.flatMap((from) => places.flatMap((to) => [0.001, 0.7, 1, 3, 1000].map((times) => pulled(zoom, from, to, times)))));
  expect(pulls.filter((zoom) => !isWithin(zoom))).toEqual([]);
});

test('the picture follows the finger until an edge is reached', () => {
  const zoom = { scale: 4, left: 0.3, top: 0.3 };
  const [from, to] = [{ x: 0.5, y: 0.5 }, { x: 0.7, y: 0.4 }];
  expectSame(inPicture(pulled(zoom, from, to), to), inPicture(zoom, from));
  expect(pulled(zoom, { x: 0, y: 0 }, { x: 50, y: -50 })).toEqual({ scale: 4, left: 0, top: 0.75 });
  expect(panned(zoom, 0.2, 0).left).toBeCloseTo(0.35, 12);
});

test('enlarging and reducing about the middle gives the same picture again', () => {
  const zoom = { scale: 3, left: 0.3, top: 0.35 };
  const again = zoomed(zoomed(zoom, 1.5), 1 / 1.5);
  for (const key of ['scale', 'left', 'top'] as const) expect(again[key]).toBeCloseTo(zoom[key], 12);
  expect(zoomed(zoom, 0)).toEqual(whole);
});

test('a finding is shown as large as it is sensible, and whole', () => {
  const size = { width: 800, height: 400 };
  for (const [box, scale] of [[[400, 200, 4, 4], most], [[390, 190, 60, 20], 800 / 180], [[300, 150, 150, 50], 3], [[0, 100, 600, 100], 800 / 750], [[0, 0, 800, 400], 1]] as const) {
    const zoom = closeTo([...box], size);
    expect(isWithin(zoom), String(box)).toBe(true);
    expect(zoom.scale, String(box)).toBeCloseTo(Math.max(1, scale), 9);
    expect(zoom.left * size.width).toBeLessThanOrEqual(box[0] + 1e-9);
    expect((zoom.left + 1 / zoom.scale) * size.width).toBeGreaterThanOrEqual(box[0] + box[2] - 1e-9);
  }
  expectSame(inPicture(centredOn([200, 100, 100, 40], size, 2), { x: 0.5, y: 0.5 }), { x: 250 / 800, y: 120 / 400 });
});

interface Done {
  zoom: Zoom;
  taps: Point[];
  doubleTaps: Point[];
  drawn: [Point, Point][];
  dropped: number;
}

function hand(draws = false): { gestures: Gestures; done: Done } {
  const done: Done = { zoom: whole, taps: [], doubleTaps: [], drawn: [], dropped: 0 };
  const handlers: Handlers = {
    size: () => ({ width: 1000, height: 500 }),
    zoom: () => done.zoom,
    setZoom: (zoom) => (done.zoom = zoom),
    draws: () => draws,
    tap: (at) => done.taps.push(at),
    doubleTap: (at) => done.doubleTaps.push(at),
    draw: (from, to, last) => last && done.drawn.push([from, to]),
    drop: () => ++done.dropped,
  };
  return { gestures: new Gestures(handlers), done };
}

test.describe('fingers', () => {
  test('spread twice as far enlarge twice, and what is under them stays there', () => {
    const { gestures, done } = hand();
    gestures.press(1, { x: 0.4, y: 0.5 });
    gestures.press(2, { x: 0.6, y: 0.5 });
    gestures.move(1, { x: 0.3, y: 0.5 });
    gestures.move(2, { x: 0.7, y: 0.5 });
    expect(done.zoom.scale).toBeCloseTo(2, 9);
    expectSame(inPicture(done.zoom, { x: 0.3, y: 0.5 }), { x: 0.4, y: 0.5 });
    gestures.release(1);
    gestures.move(2, { x: 0.8, y: 0.5 });
    expectSame(inPicture(done.zoom, { x: 0.8, y: 0.5 }), { x: 0.6, y: 0.5 });
    gestures.release(2);
    expect([done.taps, done.drawn]).toEqual([[], []]);
  });

  test('tap once or twice, and slip a little', async () => {
    const { gestures, done } = hand();
    const tap = (x: number) => {
      gestures.press(1, { x, y: 0.5 });
      gestures.move(1, { x: x + 0.005, y: 0.5 });
      gestures.release(1);
    };
    tap(0.2);
    tap(0.21);
    expect([done.taps.length, done.doubleTaps.length]).toEqual([0, 1]);
    tap(0.2);
    tap(0.8);
    await expect.poll(() => done.taps.map(({ x }) => x)).toEqual([0.2, 0.8]);
    expect(done.zoom).toEqual(whole);
  });

  test('draw, unless a second one follows', () => {
    const { gestures, done } = hand(true);
    gestures.press(1, { x: 0.2, y: 0.2 });
    gestures.move(1, { x: 0.5, y: 0.4 });
    gestures.release(1);
    expect(done.drawn).toEqual([[{ x: 0.2, y: 0.2 }, { x: 0.5, y: 0.4 }]]);
    gestures.press(1, { x: 0.2, y: 0.2 });
    gestures.move(1, { x: 0.5, y: 0.4 });
    gestures.press(2, { x: 0.8, y: 0.8 });
    gestures.release(1);
    gestures.move(2, { x: 0.7, y: 0.7 });
    gestures.release(2);
    expect([done.drawn.length, done.dropped]).toEqual([1, 1]);
    expect(done.zoom, 'the last finger moves a picture, if it is enlarged').toEqual(whole);
  });
});
