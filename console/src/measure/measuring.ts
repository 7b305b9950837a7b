// Measuring in a picture: the points that were selected, and what the server measured there.
import { useEffect, useRef, useState } from 'preact/hooks';
import { refusalOf, type Refusal } from '../link/refusal';
import type { Box, Measurement, MeasureTool, Pixel } from '../types';

/** The number of points that a tool needs; a height needs a surface as well. */
export const pointsOf: Record<MeasureTool, number> = { distance: 1, length: 2, height: 1, profile: 2 };

const allTools = Object.keys(pointsOf) as MeasureTool[];

export interface Measuring<Point = Pixel> {
  /** Whether the tools are shown. */
  active: boolean;
  tools: MeasureTool[];
  tool: MeasureTool;
  points: Point[];
  /** The region of the surface above which a height is measured, in pixels of the picture. */
  surface: Box | null;
  measured: Measurement | null;
  /** Why the request was refused; null if it was not. */
  refused: Refusal | null;
  begin: () => void;
  leave: () => void;
  clear: () => void;
  setTool: (tool: MeasureTool) => void;
  setSurface: (surface: Box) => void;
  pick: (at: Point) => void;
}

/** Whether the surface is to be drawn before a point is selected. */
export function needsSurface<Point>({ active, tool, surface }: Measuring<Point>): boolean {
  return active && tool === 'height' && surface === null;
}

interface Found {
  measured: Measurement | null;
  refused: Refusal | null;
}

const nothing: Found = { measured: null, refused: null };

/**
 * @param ask measures; rejects where the request is refused. A height has a surface
 * @param scene what the picture shows: when it changes, what was measured is no longer valid
 * @param tools those that there are; without distances, nothing is asked for the first end of a length
 */
export function useMeasuring<Point = Pixel>(ask: (tool: MeasureTool, points: Point[], surface: Box | null) => Promise<Measurement>, scene: string, tools: MeasureTool[] = allTools): Measuring<Point> {
  const [active, setActive] = useState(false);
  const [tool, setTool] = useState<MeasureTool>('length');
  const [points, setPoints] = useState<Point[]>([]);
  const [surface, setSurface] = useState<Box | null>(null);
  const [found, setFound] = useState<Found>(nothing);
  const asked = useRef(0);
  const forget = () => {
    ++asked.current;
    setFound(nothing);
  };
  const clear = () => {
    setPoints([]);
    setSurface(null);
    forget();
  };
  useEffect(clear, [scene]);
  const request = (wanted: MeasureTool, at: Point[]) => {
    const mine = ++asked.current;
    const keep = (next: Found) => mine === asked.current && setFound(next);
    ask(wanted, at, surface).then(
      (measured) => keep({ measured, refused: null }),
      (error: unknown) => keep({ measured: null, refused: refusalOf(error) }),
    );
  };
  const pick = (at: Point) => {
    const next = points.length < pointsOf[tool] ? [...points, at] : [at];
    setPoints(next);
    forget();
    if (next.length === pointsOf[tool]) request(tool, next);
    else if (tool === 'length' && tools.includes('distance')) request('distance', next);
  };
  const choose = (next: MeasureTool) => {
    setTool(next);
    clear();
  };
  const leave = () => {
    setActive(false);
    choose('length');
  };
  return { active, tools, tool, points, surface, ...found, begin: () => setActive(true), leave, clear, setTool: choose, setSurface, pick };
}
