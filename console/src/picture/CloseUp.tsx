// What was found, before and after the work side by side, with nothing drawn over it.
import './close_up.css';
import { useState } from 'preact/hooks';
import type { Size } from '../regions/shapes';
import type { Box } from '../types';
import { words } from '../words/words';
import { cropAround, most_times } from './crop';

interface Props {
  /** URLs of the whole pictures, which show the same scene pixel upon pixel; there may be none of before the work. */
  before?: string;
  after: string;
  /** Of both pictures, in pixels. */
  size: Size;
  /** What was found, in pixels of the pictures. */
  bbox: Box;
}

/** The widths of the smallest parts, in pixels of the picture: side by side, and enlarged by a tap. */
const small_px = 64;
const large_px = 200;

function Part({ address, caption, size, crop, large, onTap }: { address: string; caption: string; size: Size; crop: Box; large: boolean; onTap: () => void }) {
  const [, , width, height] = crop;
  return (
    <figure class="close-up-part">
      <button type="button" aria-label={large ? words.picture.showSmaller(caption) : words.picture.showLarger(caption)} aria-pressed={large} onClick={onTap}>
        <svg viewBox={crop.join(' ')} style={{ aspectRatio: `${width} / ${height}`, maxWidth: `${most_times * width}px` }} aria-hidden="true">
          <image href={address} width={size.width} height={size.height} />
        </svg>
      </button>
      <figcaption>{caption}</figcaption>
    </figure>
  );
}

export function CloseUp({ before, after, size, bbox }: Props) {
  const [large, setLarge] = useState(false);
  const crop = cropAround(bbox, size, large ? large_px : small_px);
  const part = { size, crop, large, onTap: () => setLarge(!large) };
  return (
    <div class={`close-up ${large ? 'large' : ''}`} data-testid="close-up">
      {before && <Part address={before} caption={words.picture.before} {...part} />}
      <Part address={after} caption={words.picture.after} {...part} />
    </div>
  );
}
