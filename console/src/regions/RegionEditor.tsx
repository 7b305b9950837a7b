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

const layers: ['color' | 'depth', string][] = [
  ['color', 'Colour'],
  ['depth', 'Depth'],
];

export function RegionEditor({ inspection, session }: { inspection: Inspection; session: Session }) {
  const state = useStore(regionState);
  const busy = isBusy(useStore(link.status)?.task);
  const [missing, setMissing] = useState<string[]>([]);
  const { view, size } = state;
  const hasColor = !missing.includes(baselineAddress(inspection, view, 'color'));
  const layer = hasColor ? state.layer : 'depth';
  const address = baselineAddress(inspection, view, layer);
  const mayChange = session.role !== 'viewer' && !busy;
  const views: [string, string][] = inspection.views.map((_, i) => [String(i), `View ${i + 1}`]);
  return (
    <section class="view" aria-label="Leave out parts of the view">
      <div class="view-bar">
        {views.length > 1 && <Choice label="View" name="regions-view" options={views} value={String(view)} onPick={(next) => showView(Number(next))} />}
        <Choice label="Picture" name="regions-picture" options={hasColor ? layers : layers.slice(1)} value={layer} onPick={(next) => change({ layer: next })} />
        {mayChange && size && <RegionTools inspection={inspection} size={size} />}
      </div>
      <div class="picture">
        <div class="picture-fit" style={{ aspectRatio: `${size?.width ?? 848} / ${size?.height ?? 480}` }}>
          <img
            class="picture-whole"
            src={address}
            alt={`View ${view + 1} before the work`}
            data-testid="regions-image"
            onLoad={(event) => change({ size: { width: event.currentTarget.naturalWidth, height: event.currentTarget.naturalHeight } })}
            onError={() => setMissing([...missing, address])}
          />
          {size && <RegionCanvas inspection={inspection} size={size} mayChange={mayChange} />}
          {missing.includes(address) && (
            <p class="picture-problem" role="alert">
              The baseline’s picture cannot be shown.
            </p>
          )}
        </div>
      </div>
    </section>
  );
}
