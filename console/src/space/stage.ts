// What the 3D view shows of a comparison: its map, what changed, its findings, and what is measured.
import type { RefObject } from 'preact';
import { useEffect, useRef, useState } from 'preact/hooks';
import { api } from '../link/api';
import { refusalOf, type Refusal } from '../link/refusal';
import type { Inspection } from '../types';
import { FindingLayer } from './FindingLayer';
import type { SpaceAction } from './keys';
import { MeasureLayer } from './MeasureLayer';
import { PointLayer } from './PointLayer';
import { Scene3d } from './Scene3d';

export interface Stage {
  scene: Scene3d;
  findings: FindingLayer;
  measure: MeasureLayer;
  /** Missing until they are loaded. */
  points?: PointLayer;
  /** Missing also where the comparison has none. */
  changes?: PointLayer;
}

export type StageState = 'loading' | 'ready' | 'no-changes' | 'no-map' | 'no-web-gl' | Refusal;

const larger_m = 0.006;

/** Shows the map from where most of it is seen. */
export function showAll({ scene, points }: Stage): void {
  if (points) scene.lookAt(points.center, points.radius_m);
}

export function perform(stage: Stage, action: SpaceAction): void {
  const { scene } = stage;
  if (action.kind === 'turn') scene.turn(action.right, action.up);
  else if (action.kind === 'move') scene.move(action.right, action.up);
  else if (action.kind === 'zoom') scene.zoom(action.times);
  else showAll(stage);
}

async function load(stage: Stage, inspection: Inspection, signal: AbortSignal): Promise<StageState> {
  const [map, changes] = await Promise.all([api.cloud(inspection, 'map', signal), api.cloud(inspection, 'changes', signal)]);
  if (!map) return 'no-map';
  stage.points = new PointLayer(map);
  stage.scene.add(stage.points.points);
  showAll(stage);
  if (!changes) return 'no-changes';
  stage.changes = new PointLayer(changes, larger_m);
  stage.scene.add(stage.changes.points);
  return 'ready';
}

function build(box: HTMLElement): Stage {
  const scene = new Scene3d(box);
  const stage: Stage = { scene, findings: new FindingLayer(), measure: new MeasureLayer() };
  scene.add(stage.findings.group);
  scene.add(stage.measure.group);
  scene.onMoving = (moving) => stage.points?.setMoving(moving);
  return stage;
}

function dispose({ scene, findings, measure, points, changes }: Stage): void {
  for (const layer of [findings, measure, points, changes]) layer?.dispose();
  scene.dispose();
}

/** @param box in which the scene is drawn */
export function useStage(box: RefObject<HTMLElement>, inspection: Inspection): { stage: RefObject<Stage>; state: StageState } {
  const stage = useRef<Stage | null>(null);
  const [state, setState] = useState<StageState>('loading');
  useEffect(() => {
    if (!box.current) return;
    setState('loading');
    let now: Stage;
    try {
      now = build(box.current);
    } catch {
      setState('no-web-gl');
      return;
    }
    stage.current = now;
    const loading = new AbortController();
    const show = (next: StageState) => !loading.signal.aborted && setState(next);
    load(now, inspection, loading.signal).then(show, (error: unknown) => show(refusalOf(error)));
    return () => {
      loading.abort();
      dispose(now);
      stage.current = null;
    };
  }, [inspection.id, inspection.comparison]);
  return { stage, state };
}
