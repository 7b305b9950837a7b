// The scale of the colours of a depth picture, beside the picture so that it hides nothing.
import type { Range } from '../types';

/** @param range_m the depths of the first and the last colour, which depths beyond them have, too */
export function DepthScale({ range_m }: { range_m: Range }) {
  const [low, high] = range_m;
  return (
    <div class="depth-scale" role="img" aria-label={`Depth colours: blue up to ${low.toFixed(2)} metres, red from ${high.toFixed(2)} metres, black where no depth was measured`} data-testid="depth-scale">
      <span class="depth-scale-bar" />
      <span class="depth-scale-labels">
        <span>≤ {low.toFixed(2)} m</span>
        <span>{((low + high) / 2).toFixed(2)}</span>
        <span>≥ {high.toFixed(2)} m</span>
      </span>
    </div>
  );
}
