// The tools for measuring, in place of the bar above a picture.
import './measure.css';
import { useLayoutEffect } from 'preact/hooks';
import { Choice } from '../Choice';
import type { MeasureTool } from '../types';
import type { Marking } from '../picture/marking';
import { needsSurface, pointsOf, type Measuring } from './measuring';
import { ProfileChart } from './ProfileChart';
import { resultText } from './result';
import { RefusalText } from '../words/RefusalText';
import { words } from '../words/words';

interface Props<Point> {
  measuring: Measuring<Point>;
  /** Selects what is in the middle of the picture: by keyboard, or where a finger would hide it. */
  onMiddle: () => void;
  /** Where heights are measured: how their surface is drawn. */
  surface?: Marking;
}

/** Starts measuring; belongs in the bar above a picture. */
export function MeasureButton<Point>({ measuring }: { measuring: Measuring<Point> }) {
  return (
    <button type="button" data-testid="measure-begin" onClick={measuring.begin}>
      {words.measure.begin}
    </button>
  );
}

function textOf<Point>(measuring: Measuring<Point>): string {
  const { measured, points, tool } = measuring;
  if (needsSurface(measuring)) return words.measure.surfaceGuide;
  if (measured) return resultText(measured);
  return points.length < pointsOf[tool] ? words.measure.guides[tool][points.length]! : words.measure.measuring;
}

export function MeasureBar<Point>({ measuring, onMiddle, surface }: Props<Point>) {
  const { tool, points, measured, leave } = measuring;
  const drawn = surface?.active && surface.byKeys ? surface.draft : null;
  // Escape also stops the robot, whatever else it does.
  useLayoutEffect(() => {
    const press = (event: KeyboardEvent) => event.key === 'Escape' && leave();
    window.addEventListener('keydown', press);
    return () => window.removeEventListener('keydown', press);
  }, []);
  const options = measuring.tools.map((name): [MeasureTool, string] => [name, words.measure.tools[name]]);
  return (
    <div class="view-bar measure-bar" data-testid="measure-bar">
      {options.length > 1 && <Choice label={words.measure.begin} name="tool" options={options} value={tool} onPick={measuring.setTool} />}
      {drawn ? (
        <button type="button" class="primary" data-testid="measure-surface" onClick={() => surface?.finish(drawn)}>
          {words.measure.takeSurface}
        </button>
      ) : (
        <button type="button" data-testid="measure-middle" onClick={onMiddle}>
          {surface?.active ? words.measure.surfaceMiddle : words.measure.middle}
        </button>
      )}
      <button type="button" data-testid="measure-clear" disabled={points.length === 0 && !measuring.surface} onClick={measuring.clear}>
        {measuring.surface ? words.measure.drawAgain : words.measure.clear}
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
