// The tools for measuring, in place of the bar above a picture.
import './measure.css';
import { useEffect } from 'preact/hooks';
import { Choice } from '../Choice';
import type { MeasureTool } from '../types';
import { pointsOf, type Measuring } from './measuring';
import { ProfileChart } from './ProfileChart';
import { resultText } from './result';
import { RefusalText } from '../words/RefusalText';
import { words } from '../words/words';

interface Props<Point> {
  measuring: Measuring<Point>;
  /** Selects what is in the middle of the picture: by keyboard, or where a finger would hide it. */
  onMiddle: () => void;
}

/** Starts measuring; belongs in the bar above a picture. */
export function MeasureButton<Point>({ measuring }: { measuring: Measuring<Point> }) {
  return (
    <button type="button" data-testid="measure-begin" onClick={measuring.begin}>
      {words.measure.begin}
    </button>
  );
}

function textOf<Point>({ measured, points, tool }: Measuring<Point>): string {
  if (measured) return resultText(measured);
  return points.length < pointsOf[tool] ? words.measure.guides[tool][points.length]! : words.measure.measuring;
}

export function MeasureBar<Point>({ measuring, onMiddle }: Props<Point>) {
  const { tool, points, measured, leave } = measuring;
  // Escape also stops the robot, whatever else it does.
  useEffect(() => {
    const press = (event: KeyboardEvent) => event.key === 'Escape' && leave();
    window.addEventListener('keydown', press);
    return () => window.removeEventListener('keydown', press);
  }, []);
  const options = measuring.tools.map((name): [MeasureTool, string] => [name, words.measure.tools[name]]);
  return (
    <div class="view-bar measure-bar" data-testid="measure-bar">
      {options.length > 1 && <Choice label={words.measure.begin} name="tool" options={options} value={tool} onPick={measuring.setTool} />}
      <button type="button" data-testid="measure-middle" onClick={onMiddle}>
        {words.measure.middle}
      </button>
      <button type="button" data-testid="measure-clear" disabled={points.length === 0} onClick={measuring.clear}>
        {words.measure.clear}
      </button>
      <button type="button" data-testid="measure-leave" onClick={leave}>
        {words.measure.leave}
      </button>
      <strong class="measure-result" role="status" data-testid="measure-result">
        {measuring.refused ? <RefusalText refusal={measuring.refused} /> : textOf(measuring)}
      </strong>
      {measured?.profile && <ProfileChart profile={measured.profile} />}
    </div>
  );
}
