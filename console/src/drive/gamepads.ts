// Copies of the browser's game controllers, since in Firefox a Gamepad changes while it is being read.

export interface Pad {
  /** Its index among the controllers that the browser lists. */
  slot: number;
  /** The id of its model: two controllers of the same model have the same id. */
  id: string;
  standard: boolean;
  axes: number[];
  /** Whether each button is pressed. */
  buttons: boolean[];
}

/** Empty if the browser does not support gamepads or denies access to them, as on an insecure origin. */
export function connectedPads(): Pad[] {
  let shown: (Gamepad | null)[];
  try {
    shown = [...navigator.getGamepads()];
  } catch {
    return [];
  }
  return shown.flatMap((pad, slot) => (pad?.connected ? [copyOf(pad, slot)] : []));
}

function copyOf(pad: Gamepad, slot: number): Pad {
  return {
    slot,
    id: pad.id,
    standard: pad.mapping === 'standard',
    axes: [...pad.axes],
    buttons: pad.buttons.map((button) => button.pressed),
  };
}

/** The name within an id such as "Xbox 360 Controller (STANDARD GAMEPAD Vendor: 045e Product: 028e)" or
 *  "045e-028e-Microsoft X-Box 360 pad". */
export function nameOf(id: string): string {
  return id.replace(/\s*\([^()]*Vendor:[^()]*\)\s*$/, '').replace(/^[0-9a-f]{1,4}-[0-9a-f]{1,4}-/i, '').trim() || 'Controller';
}
