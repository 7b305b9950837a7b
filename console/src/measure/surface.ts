// Drawing the region of the surface above which a height is measured.
import { useEffect, useState } from 'preact/hooks';
import type { Marking } from '../picture/marking';
import { boxAround, boxInMiddle } from '../picture/marks';
import type { Size } from '../regions/shapes';
import type { Box } from '../types';
import { middleOf } from './MeasureMarks';
import { needsSurface, type Measuring } from './measuring';

/** The sides of the region that a tap gives: a plane through a smaller one is less certain. */
const tap_px = 64;

/** Active while the surface is missing: then a drag draws it. @param size of the picture, in its pixels */
export function useSurface(measuring: Measuring, size: Size): Marking {
  const [{ draft, byKeys }, setState] = useState<{ draft: Box | null; byKeys: boolean }>({ draft: null, byKeys: false });
  const active = needsSurface(measuring);
  const setDraft = (next: Box | null, keys = false) => setState({ draft: next, byKeys: keys });
  useEffect(() => setDraft(null), [active]);
  const finish: Marking['finish'] = (box, line) => {
    const tapped = !line && !byKeys;
    measuring.setSurface(tapped ? boxAround(middleOf(box), size, tap_px) : box);
  };
  return { active, draft, byKeys, begin: () => undefined, leave: measuring.leave, setDraft, finish };
}

/** Selects what is in the middle of the part of the picture that is shown: a point, or a region to be moved by keys. */
export function pickMiddle(measuring: Measuring, surface: Marking, shown: Box, size: Size): void {
  if (surface.active) surface.setDraft(boxInMiddle(shown, size), true);
  else measuring.pick(middleOf(shown));
}
