// The live picture, and distances measured in it.
import './live.css';
import type { ComponentChildren } from 'preact';
import { useEffect, useRef, useState } from 'preact/hooks';
import { attempt } from '../inspection/inspections';
import { api, frozenAddress } from '../link/api';
import { link } from '../link/live_link';
import { Choice } from '../Choice';
import { MeasureBar, MeasureButton } from '../measure/MeasureBar';
import { MeasureMarks } from '../measure/MeasureMarks';
import { useMeasuring } from '../measure/measuring';
import { pickMiddle, useSurface } from '../measure/surface';
import { MarkBar, MarkButton, useMarking } from '../picture/marking';
import { shownPart, whole, type Zoom } from '../picture/zoom';
import { ZoomButtons } from '../picture/ZoomButtons';
import { ZoomPicture } from '../picture/ZoomPicture';
import { Store, useStore } from '../store';
import type { Box, FrozenPicture, PictureHead, PointingShape, Stream } from '../types';
import { DepthScale } from './DepthScale';
import { ExposureBar } from './ExposureBar';
import { PointedMarks } from './PointedMarks';
import { usePointing } from './pointing';
import { newSnapshot } from './SnapshotForm';
import { clockText, words } from '../words/words';

const shapes: PointingShape[] = ['arrow', 'circle'];

/** The part of the picture that is shown, the same of all streams. */
const liveZoom = new Store<Zoom>(whole);

interface Props {
  children?: ComponentChildren;
  /** A box that a person marked, in pixels of this live picture; undefined where nobody may mark. */
  onMark?: ((box: Box, stream: Stream) => void) | undefined;
  /** Whether this person may change the exposure. */
  mayExpose?: boolean;
  /** Whether pictures may be kept with an inspection. */
  mayKeep?: boolean;
}

// The picture that stands still, of one stream, until it is live again.
function useFreeze(stream: Stream): { frozen: FrozenPicture | null; toggle: () => void } {
  const [frozen, setFrozen] = useState<FrozenPicture | null>(null);
  useEffect(() => setFrozen(null), [stream]);
  const toggle = () => void (frozen ? setFrozen(null) : attempt(async () => setFrozen(await api.freeze(stream))));
  return { frozen, toggle };
}

export function LiveView({ children, onMark, mayExpose = false, mayKeep = false }: Props) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const status = useStore(link.status);
  const state = useStore(link.state);
  const streams = status?.camera.streams ?? [];
  const [wanted, setWanted] = useState<Stream>('color');
  const stream = streams.includes(wanted) ? wanted : (streams[0] ?? 'depth');
  const [head, setHead] = useState<PictureHead | null>(null);

  const size = head ?? { width: 848, height: 480 };
  const marking = useMarking(onMark && ((box) => onMark(box, stream)));

  useEffect(() => {
    link.watch(stream);
    return () => link.watch(null);
  }, [stream]);

  useEffect(() => {
    let last: PictureHead | null = null;
    // The last picture of another stream would be taken for one of this stream, and measured as such.
    const shown = canvas.current;
    shown?.getContext('2d')?.clearRect(0, 0, shown.width, shown.height);
    delete shown?.dataset['stream'];
    link.onPicture = ({ head: next, bitmap, latency_ms }) => {
      const target = canvas.current;
      if (!target || next.stream !== stream) return bitmap.close();
      if (target.width !== next.width || target.height !== next.height) {
        target.width = next.width;
        target.height = next.height;
      }
      target.getContext('2d')?.drawImage(bitmap, 0, 0);
      bitmap.close();
      target.dataset['stream'] = next.stream;
      target.dataset['frame'] = String(next.number);
      target.dataset['latency'] = latency_ms.toFixed(1);
      const changed = !last || last.width !== next.width || String(last.scale_m) !== String(next.scale_m);
      last = next;
      if (changed) setHead(next);
    };
    return () => {
      link.onPicture = ({ bitmap }) => bitmap.close();
    };
  }, [stream]);

  // A measurement is valid only while the camera is at rest.
  const turning = status?.robot !== undefined && (status.robot.driving || status.robot.lent);
  const { frozen, toggle: freeze } = useFreeze(stream);
  const measuring = useMeasuring(
    (tool, points, bbox) => api.measure({ stream, tool, points, ...(bbox && { bbox }), ...(frozen && { frozen: frozen.frozen }) }),
    `${stream} ${frozen ? frozen.frozen : turning}`,
  );
  const surface = useSurface(measuring, size);
  const [shape, setShape] = useState<PointingShape>('arrow');
  const pointing = usePointing(stream, shape, size);
  // Colour is exposed by an imager of its own.
  const exposure = mayExpose && stream !== 'color' ? status?.camera.exposure : undefined;
  const [exposing, setExposing] = useState(false);

  const scale_m = stream === 'depth' ? head?.scale_m : undefined;
  const problem = state !== 'open' ? words.live.lost : status?.camera.problem;
  return (
    <section class="view" aria-label={words.live.view}>
      {marking.active ? (
        <MarkBar marking={marking} size={size} zoom={liveZoom} />
      ) : pointing.active ? (
        <MarkBar marking={pointing} size={size} zoom={liveZoom} texts={words.live.pointTexts}>
          <Choice label={words.live.shape} name="shape" options={shapes.map((one) => [one, words.live.shapes[one]])} value={shape} onPick={setShape} />
        </MarkBar>
      ) : measuring.active ? (
        <MeasureBar measuring={measuring} surface={surface} onMiddle={() => pickMiddle(measuring, surface, shownPart(liveZoom.value, size), size)} />
      ) : exposing && exposure ? (
        <ExposureBar exposure={exposure} onClose={() => setExposing(false)} />
      ) : (
        <div class="view-bar">
          <div class="switch" role="radiogroup" aria-label={words.live.pictures}>
            {streams.map((name) => (
              <button
                key={name}
                type="button"
                role="radio"
                aria-checked={name === stream}
                data-testid={`stream-${name}`}
                onClick={() => setWanted(name)}
              >
                {words.live.streams[name]}
              </button>
            ))}
          </div>
          <ZoomButtons zoom={liveZoom} />
          <MeasureButton measuring={measuring} />
          <MarkButton marking={marking} shown={onMark !== undefined} />
          <button type="button" data-testid="point" onClick={pointing.begin}>
            {words.live.point}
          </button>
          <button type="button" aria-pressed={frozen !== null} data-testid="freeze" onClick={freeze}>
            {frozen ? words.live.unfreeze : words.live.freeze}
          </button>
          {exposure && (
            <button type="button" data-testid="exposure" onClick={() => setExposing(true)}>
              {words.live.exposure}
            </button>
          )}
          {mayKeep && frozen && (
            <button type="button" data-testid="snapshot" onClick={() => (newSnapshot.value = { stream, frozen: frozen.frozen })}>
              {words.live.snapshot}
            </button>
          )}
          {scale_m && <DepthScale range_m={scale_m} />}
          <span class="hint tap-hint">{scale_m ? words.live.tapDepth : words.live.tap}</span>
        </div>
      )}
      <ZoomPicture
        size={size}
        zoom={liveZoom}
        label={words.live.picture}
        overlay={(frame) => (
          <>
            {head && <MeasureMarks frame={frame} measuring={measuring} />}
            <PointedMarks stream={stream} frame={frame} size={size} />
          </>
        )}
        fixed={
          <>
            {problem && (
              <p class="picture-problem" role="alert" data-testid="live-problem">
                {problem}
              </p>
            )}
            {frozen && (
              <span class="picture-label" role="status" data-testid="frozen">
                {words.live.frozenAt(clockText(frozen.taken_at))}
              </span>
            )}
            {children}
          </>
        }
        onTap={measuring.pick}
        marking={surface.active ? surface : pointing.active ? pointing : marking}
      >
        <canvas ref={canvas} data-testid="live" aria-label={words.live.pictureOf[stream]} role="img" />
        {frozen && <img src={frozenAddress(frozen.frozen)} alt={words.live.frozenPicture} draggable={false} data-testid="frozen-picture" />}
      </ZoomPicture>
    </section>
  );
}
