// A note that a finding may be an object that was moved, with a button that shows the other finding.
import type { Group } from './groups';
import { movedFrom, movedTo } from './moves';
import { show } from './review_state';

function Other({ group, note }: { group: Group; note: string }) {
  const { lead, label } = group;
  return (
    <div class="moved" data-testid="moved">
      <p>{note}</p>
      <button type="button" onClick={() => show({ group: lead.number, view: lead.view, findings: true })}>
        Show finding {label}
      </button>
    </div>
  );
}

export function Moved({ groups, group }: { groups: Group[]; group: Group }) {
  const from = movedFrom(groups, group);
  return (
    <>
      {from && <Other group={from} note={`About the size of finding ${from.label}, which was removed: it may have been moved.`} />}
      {movedTo(groups, group).map((to) => (
        <Other key={to.label} group={to} note={`Finding ${to.label} has about the same size: it may have been moved there.`} />
      ))}
    </>
  );
}
