// Draws, selects, moves and removes regions by mouse, touch or keyboard.
import { useEffect, useId, useRef, useState } from 'preact/hooks';
import type { Corner, Inspection, Polygon } from '../types';
import { changeByKey } from './region_keys';
import { addRegion, change, regionsOf, regionState, replaceRegion } from './region_state';
import { Hatching, RegionShape, viewBoxOf } from './RegionShapes';
import { isNear, moved, rectangle, regionAt, within, type Size } from './shapes';
import { UnfinishedRegion } from './UnfinishedRegion';
import { useStore } from '../store';
import { words } from '../words/words';

interface Drag {
  from: Corner;
  to: Corner;
  /** Index of the region that is moved, and the region as it was; -1 and undefined while a new one is drawn. */
  region: number;
  before: Polygon | undefined;
  /** Whether the pointer has moved so far that this is not a tap, even one with a glove. */
  far: boolean;
}

/** How near to a corner a tap counts as a tap on it, in pixels of the screen. */
const touch_px = 24;
const glove_px = 8;

export function RegionCanvas({ inspection, size, mayChange }: { inspection: Inspection; size: Size; mayChange: boolean }) {
  const state = useStore(regionState);
  const svg = useRef<SVGSVGElement>(null);
  const [drag, setDrag] = useState<Drag | null>(null);
  const hatching = useId();
  const regions = regionsOf(inspection, state);
  const scale = () => size.width / (svg.current?.getBoundingClientRect().width || size.width);

  useEffect(() => {
    if (state.to_focus === null) return;
    const region = svg.current?.querySelector<SVGGElement>(`[data-testid="region-${state.to_focus}"]`);
    (region ?? svg.current)?.focus();
    change({ to_focus: null });
  }, [state.to_focus]);

  const placeOf = (event: PointerEvent): Corner => {
    const box = svg.current!.getBoundingClientRect();
    return within(size, [(event.clientX - box.left) * scale() - 0.5, (event.clientY - box.top) * scale() - 0.5]);
  };
  const press = (event: PointerEvent) => {
    if (!event.isPrimary || event.button !== 0 || !mayChange) return;
    const from = placeOf(event);
    const region = state.corners ? -1 : regionAt(regions, from);
    svg.current?.setPointerCapture(event.pointerId);
    setDrag({ from, to: from, region, before: regions[region], far: false });
  };
  const pull = (event: PointerEvent) => {
    if (!drag || !event.isPrimary) return;
    const to = placeOf(event);
    const far = drag.far || !isNear(drag.from, to, glove_px * scale());
    setDrag({ ...drag, to, far });
    if (far && drag.before) replaceRegion(inspection, drag.region, moved(drag.before, size, to[0] - drag.from[0], to[1] - drag.from[1]));
  };
  const letGo = (event: PointerEvent) => {
    if (!drag || !event.isPrimary) return;
    setDrag(null);
    if (state.corners) return addCorner(state.corners, placeOf(event));
    if (!drag.far) return change({ selected: drag.region, to_focus: drag.region });
    const drawn = drag.before ? null : rectangle(size, drag.from, drag.to);
    if (drawn) addRegion(inspection, drawn);
  };
  const addCorner = (corners: Corner[], place: Corner) => {
    const again = corners[0] && isNear(corners[0], place, touch_px * scale());
    if (again && corners.length >= 3) addRegion(inspection, corners);
    else if (!again) change({ corners: [...corners, place] });
  };
  const giveUp = () => {
    if (drag?.before) replaceRegion(inspection, drag.region, drag.before);
    setDrag(null);
  };

  const drawn = drag?.far && !drag.before && !state.corners ? rectangle(size, drag.from, drag.to) : null;
  return (
    <svg
      ref={svg}
      class={`overlay regions ${mayChange ? 'drawable' : ''}`}
      viewBox={viewBoxOf(size)}
      role="group"
      aria-label={words.regions.regions}
      tabindex={-1}
      data-testid="regions"
      onPointerDown={press}
      onPointerMove={pull}
      onPointerUp={letGo}
      onPointerCancel={giveUp}
    >
      <Hatching id={hatching} size={size} />
      {regions.map((region, i) => (
        <g
          key={i}
          class={`region ${i === state.selected ? 'selected' : ''}`}
          role="button"
          tabindex={0}
          aria-label={words.regions.region(i + 1)}
          aria-pressed={i === state.selected}
          data-testid={`region-${i}`}
          onFocus={() => change({ selected: i })}
          onKeyDown={(event) => mayChange && changeByKey(event, inspection, i, region, size)}
        >
          <RegionShape region={region} number={i + 1} size={size} hatching={hatching} />
          {i === state.selected && region.map(([u, v]) => <circle key={`${u} ${v}`} class="region-corner" cx={u} cy={v} r={5 * scale()} />)}
        </g>
      ))}
      {drawn && <RegionShape region={drawn} number={regions.length + 1} size={size} hatching={hatching} />}
      {state.corners && <UnfinishedRegion corners={state.corners} reach_px={touch_px * scale()} />}
    </svg>
  );
}
