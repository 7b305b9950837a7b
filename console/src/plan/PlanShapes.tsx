// The areas and places of a plan, over the picture of the baseline.
import type { Frame } from '../picture/ZoomPicture';
import type { Box, Plan, PlanPart } from '../types';
import { cornersOf } from './plan_state';

const text_px = 18;
const place_px = 6;

function PartShape({ part, frame }: { part: PlanPart; frame: Frame }) {
  const first = part.areas[0]?.[0] ?? part.places?.[0];
  return (
    <g class="plan-part" data-testid={`plan-shape-${part.name}`}>
      {part.areas.map((area, i) => (
        <g key={i}>
          <polygon class="region-halo" points={area.join(' ')} />
          <polygon class="region-outline" points={area.join(' ')} fill="none" />
        </g>
      ))}
      {part.places?.map(([u, v], i) => <circle key={i} class="plan-place" cx={u} cy={v} r={place_px * frame.screen_px} />)}
      {first && (
        <text class="region-number" x={first[0]} y={first[1]! - 7 * frame.screen_px} font-size={text_px * frame.screen_px}>
          {`${part.count} × ${part.name}`}
        </text>
      )}
    </g>
  );
}

/** @param drawn an area of parts that are still to be described */
export function PlanShapes({ plan, drawn, frame }: { plan: Plan | undefined; drawn: Box | null; frame: Frame }) {
  return (
    <svg class="overlay" viewBox={frame.viewBox} data-testid="plan-shapes">
      {plan?.coordinates === 'pixels' && plan.parts.map((part) => <PartShape key={part.name} part={part} frame={frame} />)}
      {drawn && (
        <g class="region selected">
          <polygon class="region-halo" points={cornersOf(drawn).join(' ')} />
          <polygon class="region-outline" points={cornersOf(drawn).join(' ')} fill="none" />
        </g>
      )}
    </svg>
  );
}
