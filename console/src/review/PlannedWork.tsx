// What was found of the planned work: decided together, after a look at each part.
import '../plan/plan.css';
import type { ComponentChildren } from 'preact';
import { useState } from 'preact/hooks';
import type { Inspection, PlannedWork as Work, Session } from '../types';
import { words } from '../words/words';
import { decide } from './decisions';
import { decisionOf, type Group } from './groups';

/** The groups that are planned entirely, which are listed with their part of the plan. */
export function isPlanned({ lead }: Group): boolean {
  return lead.planned === 'planned';
}

interface Props {
  inspection: Inspection;
  groups: Group[];
  session: Session;
  /** Whether decisions can be made. */
  mayDecide: boolean;
  card: (group: Group) => ComponentChildren;
}

function WorkCard({ inspection, view, work, groups, session, mayDecide, card }: Omit<Props, 'groups'> & { view: number; work: Work; groups: Group[] }) {
  const [shown, setShown] = useState(false);
  const open = groups.filter((group) => !decisionOf(group));
  const rest = [work.missing > 0 && words.plan.missing(work.missing), work.not_inspected > 0 && words.plan.notInspected(work.not_inspected)].filter(Boolean);
  return (
    <div class="card planned-work" data-testid={`planned-${work.name}`}>
      <h3>
        {work.found === work.planned ? '✓ ' : ''}
        {words.plan.found(work.found, work.planned, work.name)}
      </h3>
      {inspection.views.length > 1 && <small>{words.page.view(view + 1)}</small>}
      {rest.length > 0 && <p class="warn">{rest.join('; ')}</p>}
      {groups.length > 0 && (
        <button type="button" aria-expanded={shown} data-testid={`planned-show-${work.name}`} onClick={() => setShown(!shown)}>
          {shown ? words.plan.hide : words.plan.show(groups.length)}
        </button>
      )}
      {mayDecide && shown && open.length > 0 && (
        <button type="button" class="primary" data-testid={`planned-decide-${work.name}`} onClick={() => void decide(inspection, open, 'installed-work', '', session)}>
          {words.plan.decideAll(open.length)}
        </button>
      )}
      {shown && <ul class="list">{groups.map(card)}</ul>}
    </div>
  );
}

/** @param groups all of the inspection */
export function PlannedWork({ inspection, groups, ...rest }: Props) {
  const cards = inspection.compared.flatMap(({ view, planned = [] }) =>
    planned.map((work) => {
      const its = groups.filter((group) => isPlanned(group) && group.lead.view === view && group.lead.planned_item === work.name);
      return <WorkCard key={`${view} ${work.name}`} inspection={inspection} view={view} work={work} groups={its} {...rest} />;
    }),
  );
  if (cards.length === 0) return null;
  return (
    <section aria-label={words.plan.title} data-testid="planned-works">
      {cards}
    </section>
  );
}
