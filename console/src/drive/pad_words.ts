// Messages about the connected controllers.
import { words } from '../words/words';
import type { PadReport } from './controllers';
import { nameOf } from './gamepads';

/** Why a controller does not turn the camera, and what to do; empty if there is no such problem. */
export function noticeOf(pads: PadReport[]): string {
  const restless = pads.find(({ state }) => state === 'restless');
  if (restless) return words.drive.restless(nameOf(restless.id));
  const unmapped = pads.find(({ state }) => state === 'unmapped');
  if (unmapped && pads.every(({ state }) => state !== 'ready')) return words.drive.unmapped(nameOf(unmapped.id));
  return '';
}
