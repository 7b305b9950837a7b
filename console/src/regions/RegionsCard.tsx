// Shows in the work step what is left out of each view, with a button to change it.
import './regions.css';
import { useState } from 'preact/hooks';
import { baselineAddress } from '../link/api';
import { page } from '../pages';
import { useStore } from '../store';
import type { Inspection, Session } from '../types';
import { regionState, savedRegions, showView, unsavedViews } from './region_state';
import { percent } from './region_words';
import { StillRegions } from './RegionShapes';
import { coveredShare, type Size } from './shapes';
import { words } from '../words/words';

function LeftOut({ inspection, view }: { inspection: Inspection; view: number }) {
  const [size, setSize] = useState<Size | null>(null);
  const [layer, setLayer] = useState<'color' | 'depth'>('color');
  const regions = savedRegions(inspection, view);
  if (regions.length === 0) return null;
  return (
    <figure class="left-out" data-testid={`left-out-${view}`}>
      <div class="left-out-picture">
        <img
          class="wide"
          src={baselineAddress(inspection, view, layer)}
          alt=""
          onLoad={(event) => setSize({ width: event.currentTarget.naturalWidth, height: event.currentTarget.naturalHeight })}
          onError={() => setLayer('depth')}
        />
        {size && <StillRegions regions={regions} size={size} />}
      </div>
      <figcaption>
        {words.page.view(view + 1)}: {words.regions.count(regions.length)}
        {size && `, ${words.regions.ofPicture(percent(coveredShare(regions, size)))}`}
      </figcaption>
    </figure>
  );
}

export function RegionsCard({ inspection, session }: { inspection: Inspection; session: Session }) {
  const state = useStore(regionState);
  const unsaved = unsavedViews(inspection, state).length > 0;
  const nothing = inspection.views.every((_, view) => savedRegions(inspection, view).length === 0);
  const open = () => {
    showView(state.view);
    page.value = 'regions';
  };
  return (
    <div class="card" data-testid="regions-card">
      <h2>{words.regions.leaveOut}</h2>
      <p>{words.regions.purpose}</p>
      {nothing && <p class="hint">{words.regions.nothingIs}</p>}
      {inspection.views.map((_, view) => (
        <LeftOut key={view} inspection={inspection} view={view} />
      ))}
      {unsaved && (
        <p class="warn" role="status">
          {words.regions.unsaved}
        </p>
      )}
      <button type="button" data-testid="open-regions" onClick={open}>
        {session.role === 'viewer' ? words.regions.show : words.regions.draw}
      </button>
    </div>
  );
}
