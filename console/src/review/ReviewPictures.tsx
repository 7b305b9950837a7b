// Before and after, aligned pixel by pixel, with what changed and what could not be inspected.
import './review.css';
import { useEffect, useRef, useState } from 'preact/hooks';
import { Choice } from '../Choice';
import { api, pictureAddress } from '../link/api';
import { MeasureBar, MeasureButton } from '../measure/MeasureBar';
import { MeasureMarks } from '../measure/MeasureMarks';
import { useMeasuring, type Measuring } from '../measure/measuring';
import { pickMiddle, useSurface } from '../measure/surface';
import { MarkBar, MarkButton, useMarking, type Marking } from '../picture/marking';
import { closeTo, shownPart, whole } from '../picture/zoom';
import { ZoomButtons } from '../picture/ZoomButtons';
import { ZoomPicture, type Frame } from '../picture/ZoomPicture';
import type { Size } from '../regions/shapes';
import { useStore } from '../store';
import type { Box, FindableShare, Finding, Inspection, Pixel } from '../types';
import { FindableLegend, FindablePicture, useFindable, type FindableLayer } from './Findable';
import { FindingBoxes, findingAt, type Marked } from './FindingBoxes';
import { groupsOf, isSettled } from './groups';
import { review, reviewSize, reviewZoom, show, type Moment } from './review_state';
import { ShowMenu, Toggle } from './ShowMenu';
import { words } from '../words/words';

function moments(): [Moment, string][] {
  return [
    ['before', words.picture.before],
    ['after', words.picture.after],
    ['blink', words.review.blink],
  ];
}
const blink_ms = 700;

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

function ViewTabs({ inspection, view }: { inspection: Inspection; view: number }) {
  if (inspection.views.length < 2) return null;
  const few = inspection.views.length === 2;
  return (
    <div class="switch views" role="radiogroup" aria-label={words.page.viewLabel}>
      {inspection.views.map((_, i) => (
        <button key={i} type="button" role="radio" aria-checked={i === view} aria-label={words.page.view(i + 1)} data-testid={`review-view-${i}`} onClick={() => show({ view: i })}>
          {few ? words.page.view(i + 1) : i + 1}
        </button>
      ))}
    </div>
  );
}

// Follows the selected finding while it is to be seen closer, also into another view.
function useCloser(finding: Finding | undefined, closer: boolean, size: Size): void {
  const known = useRef(closer);
  useEffect(() => {
    if (closer && finding) reviewZoom.value = closeTo(finding.bbox, size);
    else if (!closer && known.current) reviewZoom.value = whole;
    known.current = closer;
  }, [closer, finding?.number, size.width, size.height]);
}

function keepSize({ naturalWidth: width, naturalHeight: height }: HTMLImageElement): void {
  if (width !== reviewSize.value.width || height !== reviewSize.value.height) reviewSize.value = { width, height };
}

function Layers({ inspection, view, before, found }: { inspection: Inspection; view: number; before: boolean; found: FindableLayer | null }) {
  const { layer, findings, glow, uninspected } = useStore(review);
  const address = (name: string) => pictureAddress(inspection, view, name);
  const kind = layer === 'depth' ? 'depth' : 'color';
  return (
    <>
      {layer === 'binary' ? (
        <img src={address('changes')} alt={words.review.changesPicture} draggable={false} />
      ) : (
        <>
          <img
            src={address(`final_${kind}`)}
            alt={words.review.after}
            draggable={false}
            data-testid="picture-after"
            onLoad={(event) => keepSize(event.currentTarget)}
          />
          <img src={address(`initial_${kind}`)} alt={words.review.before} draggable={false} data-testid="picture-before" class={before ? '' : 'hidden'} />
          {findings && glow && !before && <img src={address('changed')} alt="" draggable={false} class="glow" data-testid="picture-changed" />}
        </>
      )}
      {uninspected && <img src={address('not_inspected')} alt={words.review.uninspectedPicture} draggable={false} class="glow striped" data-testid="picture-uninspected" />}
      {found && <FindablePicture layer={found} />}
    </>
  );
}

function findableOf(inspection: Inspection, view: number): FindableShare[] {
  return inspection.compared.find((one) => one.view === view)?.findable ?? [];
}

interface BarProps {
  inspection: Inspection;
  view: number;
  marking: Marking;
  mayMark: boolean;
  measuring: Measuring;
}

function ReviewBar({ inspection, view, marking, mayMark, measuring }: BarProps) {
  const state = useStore(review);
  return (
    <div class="view-bar">
      <ViewTabs inspection={inspection} view={view} />
      {state.layer !== 'binary' && <Choice label={words.review.moment} name="moment" options={moments()} value={state.moment} onPick={(moment) => show({ moment })} />}
      <ZoomButtons zoom={reviewZoom} onFit={() => show({ closer: false })} />
      <Toggle label={words.review.closer} testId="closer" on={state.closer} onChange={(closer) => show({ closer })} />
      {state.layer !== 'binary' && <MeasureButton measuring={measuring} />}
      <MarkButton marking={marking} shown={mayMark} />
      <ShowMenu findable={findableOf(inspection, view)} />
    </div>
  );
}

// Measures in the picture that is shown; while both alternate, in the one after the work.
function useMeasureView(inspection: Inspection, view: number, before: boolean): Measuring {
  const side = before ? 'initial' : 'final';
  const measuring = useMeasuring((tool, points, bbox) => api.measureView(inspection, view, { side, tool, points, ...(bbox && { bbox }) }), `${inspection.comparison} ${view} ${side}`);
  const begin = () => {
    if (review.value.moment === 'blink') show({ moment: 'after' });
    measuring.begin();
  };
  return { ...measuring, begin };
}

interface Props {
  inspection: Inspection;
  /** A box that a person marked, in pixels of the picture of this view; undefined where nobody may mark. */
  onMark?: ((box: Box, view: number) => void) | undefined;
}

export function ReviewPictures({ inspection, onMark }: Props) {
  const state = useStore(review);
  const before = useBlink(state.moment);
  const view = Math.min(state.view, inspection.views.length - 1);
  const groups = groupsOf(inspection);
  const marked: Marked[] = groups.flatMap((group) =>
    group.all
      .filter((finding) => finding.view === view)
      .map((finding) => ({ finding, label: group.label, selected: group.lead.number === state.group, settled: isSettled(group) })),
  );
  const size = useStore(reviewSize);
  const found = useFindable(findableOf(inspection, view), (name) => pictureAddress(inspection, view, name));
  const here = marked.find(({ selected }) => selected);
  const marking = useMarking(onMark && ((box) => onMark(box, view)));
  useCloser(here?.finding, state.closer, size);
  const measuring = useMeasureView(inspection, view, before);
  const surface = useSurface(measuring, size);
  const pick = (at: Pixel, { screen_px }: Frame) => {
    if (measuring.active) return measuring.pick(at);
    const hit = state.findings && findingAt(marked, at, screen_px);
    if (hit) show({ group: hit.finding.same_as });
  };
  return (
    <section class="view" aria-label={words.review.beforeAfter}>
      {marking.active ? (
        <MarkBar marking={marking} size={size} zoom={reviewZoom} />
      ) : measuring.active ? (
        <MeasureBar measuring={measuring} surface={surface} onMiddle={() => pickMiddle(measuring, surface, shownPart(reviewZoom.value, size), size)} />
      ) : (
        <ReviewBar inspection={inspection} view={view} marking={marking} mayMark={onMark !== undefined} measuring={measuring} />
      )}
      <ZoomPicture
        size={size}
        zoom={reviewZoom}
        label={words.review.pictures}
        overlay={(frame) => (
          <>
            {state.findings && <FindingBoxes marked={marked} frame={frame} />}
            {measuring.active && <MeasureMarks frame={frame} measuring={measuring} />}
          </>
        )}
        fixed={
          <>
            <span class="picture-label">{state.layer === 'binary' ? words.review.changed : before ? words.picture.before : words.picture.after}</span>
            {found && <FindableLegend layer={found} />}
          </>
        }
        onTap={pick}
        marking={surface.active ? surface : marking}
      >
        <Layers inspection={inspection} view={view} before={before} found={found} />
      </ZoomPicture>
    </section>
  );
}
