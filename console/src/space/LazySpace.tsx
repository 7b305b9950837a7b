// Loads the 3D view when it is first needed, since three.js makes up most of the console.
import './space.css';
import type { FunctionComponent } from 'preact';
import { useEffect, useState } from 'preact/hooks';
import type { Inspection } from '../types';
import { words } from '../words/words';

export function LazySpace({ inspection }: { inspection: Inspection }) {
  const [View, setView] = useState<FunctionComponent<{ inspection: Inspection }> | null>(null);
  useEffect(() => {
    void import('./SpaceView').then((loaded) => setView(() => loaded.SpaceView));
  }, []);
  return View ? <View inspection={inspection} /> : <p class="hint">{words.page.loading}</p>;
}
