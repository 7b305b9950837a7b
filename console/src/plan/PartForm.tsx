// Asks what the parts of an area that was drawn are.
import { useState } from 'preact/hooks';
import { Choice } from '../Choice';
import type { Box, FindingKind, Inspection, Range } from '../types';
import { words } from '../words/words';
import { addPart, change, cornersOf } from './plan_state';

/** How far from its place a part may be; it has no effect on parts without places. */
const tolerance_mm = 10;

function NumberField({ name, label, value, step = 'any', onValue }: { name: string; label: string; value: number; step?: string; onValue: (value: number) => void }) {
  return (
    <label class="field">
      <span>{label}</span>
      <input type="number" inputMode="decimal" min={step === '1' ? 1 : 0.1} max={10000} step={step} required value={value} data-testid={`part-${name}`} onInput={(event) => onValue(event.currentTarget.valueAsNumber)} />
    </label>
  );
}

export function PartForm({ inspection, view, drawn }: { inspection: Inspection; view: number; drawn: Box }) {
  const [name, setName] = useState('');
  const [kind, setKind] = useState<FindingKind>('added');
  const [count, setCount] = useState(1);
  const [height, setHeight] = useState<Range>([5, 15]);
  const kinds: [FindingKind, string][] = [
    ['added', words.plan.kinds.added],
    ['removed', words.plan.kinds.removed],
    ['appearance', words.plan.kinds.appearance],
  ];
  const save = async (event: Event) => {
    event.preventDefault();
    const part = { name, kind, count, areas: [cornersOf(drawn)], tolerance_mm, ...(kind !== 'appearance' && { height_mm: height }) };
    if (await addPart(inspection, view, part)) change({ drawn: null });
  };
  return (
    <form class="panel-action" onSubmit={(event) => void save(event)} data-testid="part-form" aria-label={words.plan.whatIsPlanned}>
      <label class="field">
        <span>{words.plan.name}</span>
        <input value={name} required maxLength={200} placeholder={words.plan.nameExample} data-testid="part-name" onInput={(event) => setName(event.currentTarget.value)} />
      </label>
      <Choice label={words.plan.kind} name="part-kind" options={kinds} value={kind} onPick={setKind} />
      <div class="part-numbers">
        <NumberField name="count" label={words.plan.count} value={count} step="1" onValue={setCount} />
        {kind !== 'appearance' && (
          <>
            <NumberField name="height-from" label={words.plan.heightFrom} value={height[0]} onValue={(from) => setHeight([from, height[1]])} />
            <NumberField name="height-to" label={words.plan.heightTo} value={height[1]} onValue={(to) => setHeight([height[0], to])} />
          </>
        )}
      </div>
      <div class="panel-pair">
        <button type="submit" class="primary" data-testid="part-save">
          {words.plan.add}
        </button>
        <button type="button" data-testid="part-discard" onClick={() => change({ drawn: null })}>
          {words.page.discard}
        </button>
      </div>
    </form>
  );
}
