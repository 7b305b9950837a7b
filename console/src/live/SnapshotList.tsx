// The pictures that people kept with an inspection.
import { snapshotAddress } from '../link/api';
import type { Inspection } from '../types';
import { timeText, words } from '../words/words';

export function SnapshotList({ inspection }: { inspection: Inspection }) {
  const { snapshots } = inspection;
  if (snapshots.length === 0) return null;
  return (
    <details class="note snapshots" data-testid="snapshots">
      <summary>{words.live.snapshots(snapshots.length)}</summary>
      <ul class="list">
        {snapshots.map(({ number, note, person, taken_at }) => (
          <li key={number}>
            <a href={snapshotAddress(inspection, number)} target="_blank" rel="noreferrer">
              <img src={snapshotAddress(inspection, number)} alt={note || words.live.snapshotNumber(number)} loading="lazy" />
            </a>
            <span>
              {note && `${note} · `}
              {person}, {timeText(taken_at)}
            </span>
          </li>
        ))}
      </ul>
    </details>
  );
}
