// The bay in 3D, with the findings.
import { useEffect, useRef, useState } from 'preact/hooks';
import { Vector3 } from 'three';
import { api } from '../link/api';
import { MeasureBar, MeasureButton } from '../measure/MeasureBar';
import { useMeasuring } from '../measure/measuring';
import { groupsOf } from '../review/groups';
import { review, show } from '../review/review_state';
import { useStore } from '../store';
import type { Inspection, Point3 } from '../types';
import { FindingLayer } from './FindingLayer';
import { MeasureLayer } from './MeasureLayer';
import { PointLayer, type Coloring } from './PointLayer';
import { Scene3d } from './Scene3d';
import { words } from '../words/words';

const colorings: Coloring[] = ['color', 'height', 'change'];

interface Stage {
  scene: Scene3d;
  findings: FindingLayer;
  measure: MeasureLayer;
  points?: PointLayer;
  changes?: PointLayer;
}

async function load(inspection: Inspection, name: 'map' | 'changes', signal: AbortSignal): Promise<ArrayBuffer> {
  const response = await fetch(`/api/inspections/${inspection.id}/${name}?v=${inspection.comparison ?? 0}`, { signal });
  if (!response.ok) throw new Error(words.space.noMap);
  return response.arrayBuffer();
}

export function SpaceView({ inspection }: { inspection: Inspection }) {
  const box = useRef<HTMLDivElement>(null);
  const stage = useRef<Stage | null>(null);
  const [coloring, setColoring] = useState<Coloring>('color');
  const [hint, setHint] = useState(words.space.loading);
  const selected = useStore(review).group;

  useEffect(() => {
    if (!box.current) return;
    let scene: Scene3d;
    try {
      scene = new Scene3d(box.current);
    } catch {
      setHint(words.space.noWebGl);
      return;
    }
    const findings = new FindingLayer();
    const measure = new MeasureLayer();
    const now: Stage = { scene, findings, measure };
    stage.current = now;
    scene.add(findings.group);
    scene.add(measure.group);
    scene.onMoving = (moving) => now.points?.setMoving(moving);
    const loading = new AbortController();
    Promise.all([load(inspection, 'map', loading.signal), load(inspection, 'changes', loading.signal)])
      .then(([map, changes]) => {
        now.points = new PointLayer(map);
        scene.add(now.points.points);
        const largerThanOthers_m = 0.006;
        now.changes = new PointLayer(changes, largerThanOthers_m);
        scene.add(now.changes.points);
        scene.lookAt(now.points.center, now.points.radius_m);
        setHint(words.space.help);
      })
      .catch((error: Error) => {
        if (!loading.signal.aborted) setHint(error.message);
      });
    return () => {
      loading.abort();
      findings.dispose();
      measure.dispose();
      now.points?.dispose();
      now.changes?.dispose();
      scene.dispose();
      stage.current = null;
    };
  }, [inspection.id, inspection.comparison]);

  useEffect(() => {
    const now = stage.current;
    now?.points?.setColoring(coloring);
    if (now?.changes) now.changes.points.visible = coloring !== 'color';
    now?.scene.draw();
  }, [coloring, hint]);

  useEffect(() => {
    const now = stage.current;
    now?.findings.set(groupsOf(inspection), selected);
    const at = inspection.findings.find((finding) => finding.number === selected)?.in_foot_m;
    if (at && now?.points) now.scene.focus(new Vector3(...at));
    now?.scene.draw();
  }, [inspection, selected, hint]);

  const measuring = useMeasuring<Point3>((_, [from, to]) => api.measureMap(inspection.id, [from!, to!]), String(inspection.comparison), ['length']);
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

  return (
    <section class="view" aria-label={words.space.view}>
      {measuring.active ? (
        <MeasureBar measuring={measuring} onMiddle={() => pickPoint()} />
      ) : (
        <div class="view-bar">
          <div class="switch" role="radiogroup" aria-label={words.space.coloring}>
            {colorings.map((name) => (
              <button key={name} type="button" role="radio" aria-checked={coloring === name} data-testid={`coloring-${name}`} onClick={() => setColoring(name)}>
                {words.space.colorings[name]}
              </button>
            ))}
          </div>
          <button type="button" data-testid="whole-map" onClick={() => stage.current?.points && stage.current.scene.lookAt(stage.current.points.center, stage.current.points.radius_m)}>
            {words.space.all}
          </button>
          <MeasureButton measuring={measuring} />
          {coloring === 'change' && (
            <span>
              <span class="changed-mark" aria-hidden="true" /> {words.review.changed}
            </span>
          )}
          <span class="hint" role="status" data-testid="map-status">
            {hint}
          </span>
        </div>
      )}
      <div class={`space ${measuring.active ? 'measuring' : ''}`} ref={box} data-testid="space" onPointerDown={(event) => (pressed.current = { x: event.clientX, y: event.clientY })} onClick={pick} />
    </section>
  );
}
