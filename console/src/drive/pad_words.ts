// Messages about the connected controllers.
import type { PadReport, PadState } from './controllers';
import { nameOf } from './gamepads';

/** Why a controller does not turn the camera, and what to do; empty if there is no such problem. */
export function noticeOf(pads: PadReport[]): string {
  const restless = pads.find(({ state }) => state === 'restless');
  if (restless)
    return (
      `The controller's stick does not come to rest: ${nameOf(restless.id)} is ignored. ` +
      'Let go of the stick, or set a larger dead zone under “Controller”.'
    );
  const unmapped = pads.find(({ state }) => state === 'unmapped');
  if (unmapped && pads.every(({ state }) => state !== 'ready'))
    return `${nameOf(unmapped.id)} does not have the standard mapping of sticks and buttons. Teach it under “Controller”.`;
  return '';
}

export const stateWords: Record<PadState, string> = {
  ready: 'Ready.',
  unmapped: 'No standard mapping: teach which stick turns the camera and which button stops it.',
  restless: 'Ignored until its stick comes to rest.',
};
