// Enlarges a picture by buttons, for gloves.
import { useStore, type Store } from '../store';
import { words } from '../words/words';
import { most, step, whole, zoomed, type Zoom } from './zoom';

/** @param onFit called after the whole picture is shown */
export function ZoomButtons({ zoom, onFit }: { zoom: Store<Zoom>; onFit?: () => void }) {
  const { scale } = useStore(zoom);
  const fit = () => {
    zoom.value = whole;
    onFit?.();
  };
  return (
    <div class="switch" role="group" aria-label={words.picture.size}>
      <button type="button" aria-label={words.picture.larger} data-testid="zoom-in" disabled={scale >= most} onClick={() => (zoom.value = zoomed(zoom.value, step))}>
        +
      </button>
      <button type="button" aria-label={words.picture.smaller} data-testid="zoom-out" disabled={scale <= 1} onClick={() => (zoom.value = zoomed(zoom.value, 1 / step))}>
        −
      </button>
      <button type="button" data-testid="zoom-fit" disabled={scale <= 1} onClick={fit}>
        {words.picture.fit}
      </button>
    </div>
  );
}
