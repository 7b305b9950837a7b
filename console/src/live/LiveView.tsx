// The live picture, and distances measured in it.
import './live.css';
import type { ComponentChildren } from 'preact';
import { useEffect, useRef, useState } from 'preact/hooks';
import { api } from '../link/api';
import { link } from '../link/live_link';
import { MeasureBar, MeasureButton } from '../measure/MeasureBar';
import { MeasureMarks, middleOf } from '../measure/MeasureMarks';
import { useMeasuring } from '../measure/measuring';
import { MarkBar, MarkButton, useMarking } from '../picture/marking';
import { shownPart, whole, type Zoom } from '../picture/zoom';
import { ZoomButtons } from '../picture/ZoomButtons';
import { ZoomPicture } from '../picture/ZoomPicture';
import { Store, useStore } from '../store';
import type { Box, PictureHead, Stream } from '../types';
import { DepthScale } from './DepthScale';
import { words } from '../words/words';

/** The part of the picture that is shown, the same of all streams. */
const liveZoom = new Store<Zoom>(whole);

interface Props {
  children?: ComponentChildren;
  /** A box that a person marked, in pixels of this live picture; undefined where nobody may mark. */
  onMark?: ((box: Box, stream: Stream) => void) | undefined;
}

export function LiveView({ children, onMark }: Props) {
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
    link.onPicture = ({ head: next, bitmap, latency_ms }) => {
      const target = canvas.current;
      if (!target || next.stream !== stream) return bitmap.close();
      if (target.width !== next.width || target.height !== next.height) {
        target.width = next.width;
        target.height = next.height;
      }
      target.getContext('2d')?.drawImage(bitmap, 0, 0);
      bitmap.close();
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
  const measuring = useMeasuring((tool, points) => api.measure({ stream, tool, points }), `${stream} ${turning}`);

  const scale_m = stream === 'depth' ? head?.scale_m : undefined;
  const problem = state !== 'open' ? words.live.lost : status?.camera.problem;
  return (
    <section class="view" aria-label={words.live.view}>
      {marking.active ? (
        <MarkBar marking={marking} size={size} zoom={liveZoom} />
      ) : measuring.active ? (
        <MeasureBar measuring={measuring} onMiddle={() => measuring.pick(middleOf(shownPart(liveZoom.value, size)))} />
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
          {scale_m && <DepthScale range_m={scale_m} />}
          <span class="hint">{scale_m ? words.live.tapDepth : words.live.tap}</span>
        </div>
      )}
      <ZoomPicture
        size={size}
        zoom={liveZoom}
        label={words.live.picture}
        overlay={(frame) => head && <MeasureMarks frame={frame} measuring={measuring} />}
        fixed={
          <>
            {problem && (
              <p class="picture-problem" role="alert" data-testid="live-problem">
                {problem}
              </p>
            )}
            {children}
          </>
        }
        onTap={measuring.pick}
        marking={marking}
      >
        <canvas ref={canvas} data-testid="live" aria-label={words.live.pictureOf[stream]} role="img" />
      </ZoomPicture>
    </section>
  );
}
