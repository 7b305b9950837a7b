// What the review's picture shows: the layer, and what is drawn over it.
import { useState } from 'preact/hooks';
import { Choice } from '../Choice';
import { useStore } from '../store';
import type { FindableShare } from '../types';
import { FindableChoice } from './Findable';
import { review, show, type Layer } from './review_state';
import { words } from '../words/words';

const layers: Layer[] = ['color', 'depth', 'binary'];

export function Toggle({ label, on, testId, onChange }: { label: string; on: boolean; testId: string; onChange: (on: boolean) => void }) {
  return (
    <button type="button" class="toggle" role="switch" aria-checked={on} data-testid={testId} onClick={() => onChange(!on)}>
      <span aria-hidden="true">{on ? '☑' : '☐'}</span> {label}
    </button>
  );
}

/** @param findable of the view that is shown; empty where it is not known */
export function ShowMenu({ findable }: { findable: FindableShare[] }) {
  const state = useStore(review);
  const [open, setOpen] = useState(false);
  return (
    <div class="show-menu">
      <button type="button" aria-expanded={open} aria-controls="show-menu" data-testid="show-menu" onClick={() => setOpen(!open)}>
        {words.review.show} <span aria-hidden="true">{open ? '▴' : '▾'}</span>
      </button>
      {open && (
        <div class="card" id="show-menu" role="group" aria-label={words.review.whatPictureShows}>
          <Choice label={words.live.pictures} name="picture" options={layers.map((layer) => [layer, words.review.layers[layer]])} value={state.layer} onPick={(layer) => show({ layer })} />
          <Toggle label={words.review.findings} testId="show-findings" on={state.findings} onChange={(findings) => show({ findings })} />
          <Toggle label={words.review.changes} testId="show-glow" on={state.glow} onChange={(glow) => show({ glow })} />
          <Toggle label={words.review.notInspected} testId="show-uninspected" on={state.uninspected} onChange={(uninspected) => show({ uninspected })} />
          {findable.length > 0 && <FindableChoice findable={findable} />}
        </div>
      )}
    </div>
  );
}
