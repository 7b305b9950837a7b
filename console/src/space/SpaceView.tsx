// The bay in 3D, with the findings.
import { useEffect, useRef, useState } from 'preact/hooks';
import { Vector3 } from 'three';
import { Choice } from '../Choice';
import { api } from '../link/api';
import { Refusal } from '../link/refusal';
import { MeasureBar, MeasureButton } from '../measure/MeasureBar';
import { useMeasuring } from '../measure/measuring';
import { groupsOf } from '../review/groups';
import { review, show } from '../review/review_state';
import { useStore } from '../store';
import type { Inspection, Point3 } from '../types';
import { RefusalText } from '../words/RefusalText';
import { words } from '../words/words';
import { actionOf } from './keys';
import type { Coloring } from './PointLayer';
import { perform, showAll, useStage, type StageState } from './stage';

const colorings: Coloring[] = ['color', 'height', 'change'];

// Why nothing is shown; null where the map is.
function Missing({ state }: { state: StageState }) {
  if (state === 'ready' || state === 'no-changes') return null;
  const texts = { loading: words.space.loading, 'no-map': words.space.noMap, 'no-web-gl': words.space.noWebGl };
  return (
    <p class="space-missing" role="status" data-testid="map-missing">
      {state instanceof Refusal ? <RefusalText refusal={state} /> : texts[state]}
    </p>
  );
}

export function SpaceView({ inspection }: { inspection: Inspection }) {
  const box = useRef<HTMLDivElement>(null);
  const { stage, state } = useStage(box, inspection);
  const [coloring, setColoring] = useState<Coloring>('color');
  const selected = useStore(review).group;
  const shown = state === 'ready' || state === 'no-changes';

  useEffect(() => {
    const now = stage.current;
    now?.points?.setColoring(coloring);
    if (now?.changes) now.changes.points.visible = coloring !== 'color';
    now?.scene.draw();
  }, [coloring, state]);

  useEffect(() => {
    const now = stage.current;
    now?.findings.set(groupsOf(inspection), selected);
    const at = inspection.findings.find((finding) => finding.number === selected)?.in_foot_m;
    if (at && now?.points) now.scene.focus(new Vector3(...at));
    now?.scene.draw();
  }, [inspection.id, inspection.comparison, inspection.findings, inspection.marked, selected, state]);

  const measuring = useMeasuring<Point3>((_, [from, to]) => api.measureMap(inspection, [from!, to!]), String(inspection.comparison), ['length']);
  useEffect(() => {
    stage.current?.measure.set(measuring.points);
    stage.current?.scene.draw();
  }, [measuring.points]);

  // By default what is in the middle.
  const pickPoint = (event?: MouseEvent) => {
    const now = stage.current;
    const at = now?.points && now.scene.pickPoint(now.points.points, event);
    if (at) measuring.pick([at.x, at.y, at.z]);
  };

  // A click that ends a turn of the view selects nothing.
  const pressed = useRef({ x: 0, y: 0 });
  const pick = (event: MouseEvent) => {
    const far_px = 10;
    if (Math.hypot(event.clientX - pressed.current.x, event.clientY - pressed.current.y) > far_px) return;
    if (measuring.active) return pickPoint(event);
    const hit = stage.current?.scene.pick(event, stage.current.findings.group.children);
    const number: unknown = hit?.userData['number'];
    if (typeof number === 'number') show({ group: number, findings: true });
  };

  // A key that turns the map does not turn the camera as well, which arrow keys do elsewhere.
  const pressKey = (event: KeyboardEvent) => {
    const action = actionOf(event);
    const now = stage.current;
    if (!action || !now?.points) return;
    event.preventDefault();
    event.stopPropagation();
    now.points.setMoving(event.repeat);
    perform(now, action);
  };
  const rest = () => {
    stage.current?.points?.setMoving(false);
    stage.current?.scene.draw();
  };

  return (
    <section class="view" aria-label={words.space.view}>
      {shown && measuring.active && <MeasureBar measuring={measuring} onMiddle={() => pickPoint()} />}
      {shown && !measuring.active && (
        <div class="view-bar">
          <Choice label={words.space.coloring} name="coloring" options={colorings.map((name) => [name, words.space.colorings[name]])} value={coloring} onPick={setColoring} />
          <button type="button" data-testid="whole-map" onClick={() => stage.current && showAll(stage.current)}>
            {words.space.all}
          </button>
          <MeasureButton measuring={measuring} />
          {coloring === 'change' && state === 'ready' && (
            <span>
              <span class="changed-mark" aria-hidden="true" /> {words.review.changed}
            </span>
          )}
          <span class="hint" role="status" data-testid="map-status">
            {coloring === 'change' && state === 'no-changes' ? words.space.noChanges : words.space.help}
          </span>
        </div>
      )}
      <div class="space-frame">
        <div
          ref={box}
          class={`space ${measuring.active ? 'measuring' : ''}`}
          role="group"
          tabIndex={0}
          aria-label={words.space.keys}
          aria-keyshortcuts="+ - 0"
          data-testid="space"
          onPointerDown={(event) => (pressed.current = { x: event.clientX, y: event.clientY })}
          onClick={pick}
          onKeyDown={pressKey}
          onKeyUp={rest}
          onBlur={rest}
        />
        <Missing state={state} />
      </div>
    </section>
  );
}
