// Shows whether a capture can begin, and if not, why.
import { useEffect } from 'preact/hooks';
import { api } from '../link/api';
import { link } from '../link/live_link';
import { useStore } from '../store';
import { attempt } from './inspections';

const old_ms = 10 * 60 * 1000;

export function ReadinessCard({ mayCapture }: { mayCapture: boolean }) {
  const status = useStore(link.status);
  const readiness = status?.readiness;
  const busy = status?.task.end === 'running';
  const checking = busy && status?.task.kind === 'readiness';
  const isOld = !readiness || Date.now() - Date.parse(readiness.checked_at) > old_ms;
  const known = status !== null;

  useEffect(() => {
    if (known && isOld && !busy && mayCapture) void attempt(() => api.checkReadiness());
  }, [known]);

  return (
    <div class="card" data-testid="readiness">
      <h2>Ready?</h2>
      <ul class="checks">
        {readiness?.items.map((item) => (
          <li key={item.name} class={item.ready ? 'good' : 'bad'}>
            <span class="check-mark" aria-hidden="true">
              {item.ready ? '✓' : '✗'}
            </span>
            <span>
              <strong>
                {item.name}: {item.ready ? 'ready' : 'not ready'}
              </strong>
              <br />
              {item.says}
            </span>
          </li>
        ))}
      </ul>
      {checking && (
        <p class="hint" role="status">
          Checking the camera: {status.task.done} of {status.task.total || '…'} frames
        </p>
      )}
      <button type="button" data-testid="check" disabled={busy || !mayCapture} onClick={() => void attempt(() => api.checkReadiness())}>
        Check {readiness ? 'again' : ''}
      </button>
    </div>
  );
}
