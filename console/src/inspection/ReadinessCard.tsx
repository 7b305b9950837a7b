// Shows whether a capture can begin, and if not, why.
import { useEffect } from 'preact/hooks';
import { api } from '../link/api';
import { link } from '../link/live_link';
import { useStore } from '../store';
import { attempt } from './inspections';
import { readinessName, readinessText } from './readiness';
import { words } from '../words/words';

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
      <h2>{words.inspection.readyQuestion}</h2>
      <ul class="checks">
        {readiness?.items.map((item) => (
          <li key={item.name} class={item.ready ? 'good' : 'bad'}>
            <span class="check-mark" aria-hidden="true">
              {item.ready ? '✓' : '✗'}
            </span>
            <span>
              <strong>
                {readinessName(item.name)}: {item.ready ? words.inspection.ready : words.inspection.notReady}
              </strong>
              <br />
              {readinessText(item) ?? <span lang="en">{item.says}</span>}
            </span>
          </li>
        ))}
      </ul>
      {checking && (
        <p class="hint" role="status">
          {words.inspection.checkingCamera(status.task.done, status.task.total)}
        </p>
      )}
      <button type="button" data-testid="check" disabled={busy || !mayCapture} onClick={() => void attempt(() => api.checkReadiness())}>
        {readiness ? words.inspection.checkAgain : words.inspection.check}
      </button>
    </div>
  );
}
