// Where objects of one size would have been found: a layer of the review's picture, its choice and its legend.
import { useState } from 'preact/hooks';
import { Choice } from '../Choice';
import { percent } from '../regions/region_words';
import { useStore } from '../store';
import type { FindableShare } from '../types';
import { review, show } from './review_state';
import { words } from '../words/words';

/** Of one size at a time, since what would be found of small objects would be found of large ones, too. */
export function FindableChoice({ findable }: { findable: FindableShare[] }) {
  const { findable_mm } = useStore(review);
  const label = words.review.findable;
  const options: [string, string][] = [['0', words.review.findableNone], ...findable.map(({ size_mm }): [string, string] => [String(size_mm), `${size_mm} mm`])];
  return (
    <div class="findable-choice">
      <span aria-hidden="true">{label}</span>
      <Choice label={label} name="findable" options={options} value={String(findable_mm)} onPick={(size) => show({ findable_mm: Number(size) })} />
    </div>
  );
}

/** What is drawn of a size: its picture, which comparisons of earlier versions lack, and what the legend states. */
export interface FindableLayer {
  size_mm: number;
  share: number;
  address: string;
  missing: boolean;
  onMissing: () => void;
}

/** @param findable of the view that is shown @param addressOf the URL of a picture of this view */
export function useFindable(findable: FindableShare[], addressOf: (name: string) => string): FindableLayer | null {
  const { findable_mm } = useStore(review);
  const [missing, setMissing] = useState('');
  const chosen = findable.find(({ size_mm }) => size_mm === findable_mm);
  if (!chosen) return null;
  const address = addressOf(`findable_${findable_mm}mm`);
  return { ...chosen, address, missing: missing === address, onMissing: () => setMissing(address) };
}

export function FindablePicture({ layer }: { layer: FindableLayer }) {
  if (layer.missing) return null;
  return <img src={layer.address} alt={words.review.findablePicture(layer.size_mm)} draggable={false} class="glow dotted" data-testid="picture-findable" onError={layer.onMissing} />;
}

export function FindableLegend({ layer }: { layer: FindableLayer }) {
  return (
    <span class="picture-label findable-legend" role="status" data-testid="findable-legend">
      {layer.missing ? (
        words.review.findableMissing
      ) : (
        <>
          <span class="dots" aria-hidden="true" /> {words.review.findableShare(layer.size_mm, percent(layer.share))}
        </>
      )}
    </span>
  );
}
