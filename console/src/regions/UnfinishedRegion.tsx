// A region whose corners are still being tapped. A tap on the first corner closes it.
import type { Corner } from '../types';

export function UnfinishedRegion({ corners, reach_px }: { corners: Corner[]; reach_px: number }) {
  const points = corners.map(([u, v]) => `${u},${v}`).join(' ');
  const [first] = corners;
  return (
    <g data-testid="unfinished">
      <polyline class="region-halo" points={points} />
      <polyline class="region-outline" points={points} fill="none" />
      {corners.map(([u, v]) => (
        <circle key={`${u} ${v}`} class="region-corner" cx={u} cy={v} r={reach_px / 5} />
      ))}
      {first && corners.length >= 3 && <circle class="region-close" cx={first[0]} cy={first[1]} r={reach_px} />}
    </g>
  );
}
