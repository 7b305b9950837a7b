// A note that a finding may be an object that was moved, with a button that shows the other finding.
import type { Group } from './groups';
import { movedFrom, movedTo } from './moves';
import { show } from './review_state';
import { words } from '../words/words';

function Other({ group, note }: { group: Group; note: string }) {
  const { lead, label } = group;
  return (
    <div class="moved" data-testid="moved">
      <p>{note}</p>
      <button type="button" onClick={() => show({ group: lead.number, view: lead.view, findings: true })}>
        {words.review.showFinding(label)}
      </button>
    </div>
  );
}

export function Moved({ groups, group }: { groups: Group[]; group: Group }) {
  const from = movedFrom(groups, group);
  return (
    <>
      {from && <Other group={from} note={words.review.mayBeMovedFrom(from.label)} />}
      {movedTo(groups, group).map((to) => (
        <Other key={to.label} group={to} note={words.review.mayBeMovedTo(to.label)} />
      ))}
    </>
  );
}
