// The baseline's picture of a view, with what is left out of the comparison drawn over it.
import './regions.css';
import { useState } from 'preact/hooks';
import { Choice } from '../Choice';
import { isBusy } from '../inspection/inspections';
import { baselineAddress } from '../link/api';
import { link } from '../link/live_link';
import { useStore } from '../store';
import type { Inspection, Session } from '../types';
import { RegionCanvas } from './RegionCanvas';
import { change, regionState, showView } from './region_state';
import { RegionTools } from './RegionTools';
import { words } from '../words/words';

function layers(): ['color' | 'depth', string][] {
  return [
    ['color', words.live.streams.color],
    ['depth', words.live.streams.depth],
  ];
}

export function RegionEditor({ inspection, session }: { inspection: Inspection; session: Session }) {
  const state = useStore(regionState);
  const busy = isBusy(useStore(link.status)?.task);
  const [missing, setMissing] = useState<string[]>([]);
  const { view, size } = state;
  const hasColor = !missing.includes(baselineAddress(inspection, view, 'color'));
  const layer = hasColor ? state.layer : 'depth';
  const address = baselineAddress(inspection, view, layer);
  const mayChange = session.role !== 'viewer' && !busy;
  const views: [string, string][] = inspection.views.map((_, i) => [String(i), words.page.view(i + 1)]);
  return (
    <section class="view" aria-label={words.regions.leaveOut}>
      <div class="view-bar">
        {views.length > 1 && <Choice label={words.page.viewLabel} name="regions-view" options={views} value={String(view)} onPick={(next) => showView(Number(next))} />}
        <Choice label={words.live.pictures} name="regions-picture" options={hasColor ? layers() : layers().slice(1)} value={layer} onPick={(next) => change({ layer: next })} />
        {mayChange && size && <RegionTools inspection={inspection} size={size} />}
      </div>
      <div class="picture">
        <div class="picture-fit" style={{ aspectRatio: `${size?.width ?? 848} / ${size?.height ?? 480}` }}>
          <img
            class="picture-whole"
            src={address}
            alt={words.regions.pictureOfView(view + 1)}
            data-testid="regions-image"
            onLoad={(event) => change({ size: { width: event.currentTarget.naturalWidth, height: event.currentTarget.naturalHeight } })}
            onError={() => setMissing([...missing, address])}
          />
          {size && <RegionCanvas inspection={inspection} size={size} mayChange={mayChange} />}
          {missing.includes(address) && (
            <p class="picture-problem" role="alert">
              {words.regions.noPicture}
            </p>
          )}
        </div>
      </div>
    </section>
  );
}
