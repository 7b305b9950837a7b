// The tools for measuring, in place of the bar above a picture.
import './measure.css';
import { useEffect } from 'preact/hooks';
import { Choice } from '../Choice';
import type { MeasureTool } from '../types';
import { pointsOf, type Measuring } from './measuring';
import { ProfileChart } from './ProfileChart';
import { resultText } from './result';

const names: [MeasureTool, string][] = [
  ['distance', 'Distance'],
  ['length', 'Length'],
  ['height', 'Height'],
  ['profile', 'Profile'],
];

const guides: Record<MeasureTool, string[]> = {
  distance: ['Tap a point for its distance from the camera.'],
  length: ['Tap the first end.', 'Tap the other end.'],
  height: ['Tap three points of the surface: the first.', 'The second point of the surface.', 'The third point of the surface.', 'Tap the point above the surface.'],
  profile: ['Tap the first end of the line.', 'Tap its other end.'],
};

interface Props<Point> {
  measuring: Measuring<Point>;
  /** Selects what is in the middle of the picture: by keyboard, or where a finger would hide it. */
  onMiddle: () => void;
}

/** Starts measuring; belongs in the bar above a picture. */
export function MeasureButton<Point>({ measuring }: { measuring: Measuring<Point> }) {
  return (
    <button type="button" data-testid="measure-begin" onClick={measuring.begin}>
      Measure
    </button>
  );
}

function textOf<Point>({ measured, refused, points, tool }: Measuring<Point>): string {
  if (refused) return refused;
  if (measured) return resultText(measured);
  return points.length < pointsOf[tool] ? guides[tool][points.length]! : 'Measuring…';
}

export function MeasureBar<Point>({ measuring, onMiddle }: Props<Point>) {
  const { tool, points, measured, leave } = measuring;
  // Escape also stops the robot, whatever else it does.
  useEffect(() => {
    const press = (event: KeyboardEvent) => event.key === 'Escape' && leave();
    window.addEventListener('keydown', press);
    return () => window.removeEventListener('keydown', press);
  }, []);
  const options = names.filter(([name]) => measuring.tools.includes(name));
  return (
    <div class="view-bar measure-bar" data-testid="measure-bar">
      {options.length > 1 && <Choice label="Measure" name="tool" options={options} value={tool} onPick={measuring.setTool} />}
      <button type="button" data-testid="measure-middle" onClick={onMiddle}>
        Point in the middle
      </button>
      <button type="button" data-testid="measure-clear" disabled={points.length === 0} onClick={measuring.clear}>
        Clear
      </button>
      <button type="button" data-testid="measure-leave" onClick={leave}>
        Done
      </button>
      <strong class="measure-result" role="status" data-testid="measure-result">
        {textOf(measuring)}
      </strong>
      {measured?.profile && <ProfileChart profile={measured.profile} />}
    </div>
  );
}
