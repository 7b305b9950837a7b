// Before and after, aligned pixel by pixel, with what changed and what could not be inspected.
import './review.css';
import { useEffect, useState } from 'preact/hooks';
import { Choice } from '../Choice';
import { pictureAddress } from '../link/api';
import { signOf } from '../inspection/words';
import { useStore } from '../store';
import type { Finding, Inspection } from '../types';
import { CoverageText } from './CoverageText';
import { groupsOf, type Group } from './groups';
import { review, show, type Layer, type Moment } from './review_state';

const layers: [Layer, string][] = [
  ['color', 'Colour'],
  ['depth', 'Depth'],
  ['binary', 'Changes only'],
];
const moments: [Moment, string][] = [
  ['before', 'Before'],
  ['after', 'After'],
  ['blink', 'Blink'],
];
const blink_ms = 700;

function Toggle({ label, on, testId, onChange }: { label: string; on: boolean; testId: string; onChange: (on: boolean) => void }) {
  return (
    <button type="button" class="toggle" role="switch" aria-checked={on} data-testid={testId} onClick={() => onChange(!on)}>
      <span aria-hidden="true">{on ? '☑' : '☐'}</span> {label}
    </button>
  );
}

// Whether to show the picture before the work; alternates while blinking.
function useBlink(moment: Moment): boolean {
  const [before, setBefore] = useState(false);
  useEffect(() => {
    if (moment !== 'blink') return setBefore(moment === 'before');
    const timer = setInterval(() => setBefore((now) => !now), blink_ms);
    return () => clearInterval(timer);
  }, [moment]);
  return before;
}

function FindingBox({ finding, number, selected, onPick }: { finding: Finding; number: number; selected: boolean; onPick: () => void }) {
  const [x, y, width, height] = finding.bbox;
  const gap = 6;
  return (
    <g class={`finding-box ${finding.kind} ${selected ? 'selected' : ''}`} onClick={onPick}>
      <rect class="halo" x={x - gap} y={y - gap} width={width + 2 * gap} height={height + 2 * gap} rx="4" />
      <rect x={x - gap} y={y - gap} width={width + 2 * gap} height={height + 2 * gap} rx="4" />
      <text x={x - gap} y={y - gap - 5}>
        {`${number} ${signOf(finding.kind)}`}
      </text>
    </g>
  );
}

function viewsOf(group: Group): string {
  const views = [...new Set(group.all.map((finding) => finding.view + 1))];
  return `view ${views.join(' and ')}`;
}

// Three times as large, with the finding in the middle as far as the picture's edges allow.
function enlarged(finding: Finding, size: { width: number; height: number }): { transform: string } {
  const times = 3;
  const shift = (middle: number, length: number) => Math.max(1 - times, Math.min(0, 0.5 - (times * middle) / length));
  const [x, y, width, height] = finding.bbox;
  return {
    transform: `translate(${100 * shift(x + width / 2, size.width)}%, ${100 * shift(y + height / 2, size.height)}%) scale(${times})`,
  };
}

function ViewTabs({ inspection, view }: { inspection: Inspection; view: number }) {
  if (inspection.views.length < 2) return null;
  return (
    <div class="switch" role="radiogroup" aria-label="View">
      {inspection.views.map((_, i) => (
        <button key={i} type="button" role="radio" aria-checked={i === view} data-testid={`review-view-${i}`} onClick={() => show({ view: i })}>
          View {i + 1}
        </button>
      ))}
    </div>
  );
}

export function ReviewPictures({ inspection }: { inspection: Inspection }) {
  const state = useStore(review);
  const before = useBlink(state.moment);
  const view = Math.min(state.view, inspection.views.length - 1);
  const address = (name: string) => pictureAddress(inspection, view, name);
  const kind = state.layer === 'depth' ? 'depth' : 'color';
  const groups = groupsOf(inspection);
  const here = groups.flatMap((group) => group.all.filter((finding) => finding.view === view).map((finding) => ({ group, finding })));
  const coverage = inspection.compared.find((compared) => compared.view === view);
  const width = 848;
  const [size, setSize] = useState({ width, height: 480 });
  const chosen = groups.find((group) => group.lead.number === state.group);
  const closer = state.closer ? here.find(({ group }) => group === chosen)?.finding : undefined;
  return (
    <section class="view" aria-label="Before and after">
      <div class="view-bar">
        <ViewTabs inspection={inspection} view={view} />
        <Choice label="Picture" options={layers} value={state.layer} onPick={(layer) => show({ layer })} />
        {state.layer !== 'binary' && <Choice label="Moment" options={moments} value={state.moment} onPick={(moment) => show({ moment })} />}
        <Toggle label="Findings" testId="show-findings" on={state.findings} onChange={(findings) => show({ findings })} />
        <Toggle label="Closer" testId="closer" on={state.closer} onChange={(next) => show({ closer: next })} />
        <Toggle label="Not inspected" testId="show-uninspected" on={state.uninspected} onChange={(uninspected) => show({ uninspected })} />
      </div>
      <div class="picture">
        <div class="picture-fit" style={{ aspectRatio: `${size.width} / ${size.height}` }}>
          <div class="layers" style={closer && enlarged(closer, size)}>
            {state.layer === 'binary' ? (
              <img src={address('changes')} alt="White: changed" />
            ) : (
              <>
                <img
                  src={address(`final_${kind}`)}
                  alt="After the work"
                  data-testid="picture-after"
                  onLoad={(event) => setSize({ width: event.currentTarget.naturalWidth, height: event.currentTarget.naturalHeight })}
                />
                <img src={address(`initial_${kind}`)} alt="Before the work" data-testid="picture-before" class={before ? '' : 'hidden'} />
                {state.findings && !before && <img src={address('changed')} alt="" class="glow" />}
              </>
            )}
            {state.uninspected && <img src={address('not_inspected')} alt="Striped: could not be inspected" class="glow" data-testid="picture-uninspected" />}
            {state.findings && (
              <svg class="overlay clickable" viewBox={`0 0 ${size.width} ${size.height}`} data-testid="boxes">
                {here.map(({ group, finding }) => (
                  <FindingBox
                    key={finding.number}
                    finding={finding}
                    number={group.label}
                    selected={group.lead.number === state.group}
                    onPick={() => show({ group: group.lead.number })}
                  />
                ))}
              </svg>
            )}
          </div>
          <span class="picture-label">{state.layer === 'binary' ? 'Changed' : before ? 'Before' : 'After'}</span>
        </div>
      </div>
      {chosen && !here.some(({ group }) => group === chosen) && (
        <p class="coverage" data-testid="not-here">
          Finding {chosen.label} was found in {viewsOf(chosen)} only. That it is not marked here is no evidence against it.
        </p>
      )}
      {coverage && <CoverageText compared={coverage} marked={state.findings} />}
    </section>
  );
}
