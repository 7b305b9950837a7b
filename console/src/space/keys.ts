// What keys do to the 3D view.

export type SpaceAction = { kind: 'turn' | 'move'; right: number; up: number } | { kind: 'zoom'; times: number } | { kind: 'reset' };

const step = 1.25;

const arrows: Record<string, [number, number]> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

/** The action of a key: the camera turns or moves to the side of the arrow. Null for all other keys. */
export function actionOf({ key, shiftKey, ctrlKey, altKey, metaKey }: Pick<KeyboardEvent, 'key' | 'shiftKey' | 'ctrlKey' | 'altKey' | 'metaKey'>): SpaceAction | null {
  if (ctrlKey || altKey || metaKey) return null;
  const arrow = arrows[key];
  if (arrow) return { kind: shiftKey ? 'move' : 'turn', right: arrow[0], up: arrow[1] };
  if (key === '+' || key === '=') return { kind: 'zoom', times: 1 / step };
  if (key === '-') return { kind: 'zoom', times: step };
  return key === '0' ? { kind: 'reset' } : null;
}
