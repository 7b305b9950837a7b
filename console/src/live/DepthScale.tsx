// The scale of the colours of a depth picture, beside the picture so that it hides nothing.
import type { Range } from '../types';
import { decimal, words } from '../words/words';

/** @param range_m the depths of the first and the last colour, which depths beyond them have, too */
export function DepthScale({ range_m }: { range_m: Range }) {
  const [low, high] = range_m;
  const [low_m, middle_m, high_m] = [low, (low + high) / 2, high].map((depth_m) => decimal(depth_m, 2)) as [string, string, string];
  return (
    <div class="depth-scale" role="img" aria-label={words.live.depthScale(low_m, high_m)} data-testid="depth-scale">
      <span class="depth-scale-bar" />
      <span class="depth-scale-labels">
        <span>≤ {low_m} m</span>
        <span>{middle_m}</span>
        <span>≥ {high_m} m</span>
      </span>
    </div>
  );
}
