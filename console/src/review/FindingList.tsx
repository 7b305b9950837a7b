// Findings, most suspicious first, each to be decided.
import './review.css';
import { useEffect, useRef } from 'preact/hooks';
import { markedAddress, pictureAddress } from '../link/api';
import { CloseUp } from '../picture/CloseUp';
import { percent } from '../regions/region_words';
import { openInspection } from '../inspection/inspections';
import { findableText, leastFindable, signOf, suspicion, timeOf, whatChanged, whereAndHow } from '../inspection/words';
import { useStore } from '../store';
import type { Inspection, Session, Verdict } from '../types';
import { CheckoutCard } from '../checkout/CheckoutCard';
import { ClosingCard } from './ClosingCard';
import { decide } from './decisions';
import { DecisionForm } from './DecisionForm';
import { bestSeen, decisionOf, groupsOf, isSettled, type Group } from './groups';
import { Moved } from './Moved';
import { review, reviewSize, selectionOf, several, show } from './review_state';
import { isPlanned, PlannedWork } from './PlannedWork';
import { RoundsCard } from './RoundsCard';
import { SeveralForm, toggleSeveral } from './SeveralForm';
import { useSwipe, type Direction } from './swipe';
import { UndoBar } from './UndoBar';
import { percentText, words } from '../words/words';
import { Rich } from '../words/Rich';

function SuspicionBar({ level, name }: { level: number; name: string }) {
  return (
    <span class="suspicion">
      <span aria-hidden="true">{'●'.repeat(level) + '○'.repeat(3 - level)}</span> {name}
    </span>
  );
}

function DecisionText({ group }: { group: Group }) {
  const decision = decisionOf(group);
  if (!decision) return <small class="open">{words.review.toBeDecided}</small>;
  const settled = isSettled(group);
  return (
    <small class={settled ? 'said' : 'open'}>
      {settled ? '✓' : '…'} {words.finding.verdicts[decision.verdict]}
      {decision.note && <q>{decision.note}</q>}
    </small>
  );
}

// What a swipe of a card decides.
const swiped: Record<Direction, Verdict> = { right: 'debris', left: 'false-alarm' };

interface CardProps {
  inspection: Inspection;
  groups: Group[];
  group: Group;
  session: Session;
  past: boolean;
  selected: boolean;
  /** Whether it is among those that are decided together; undefined while findings are decided one by one. */
  ticked: boolean | undefined;
}

function FindingCard({ inspection, groups, group, session, past, selected, ticked }: CardProps) {
  const { lead, all, marked } = group;
  const decision = decisionOf(group);
  const { level, name } = suspicion(lead);
  const pictures = <Pictures inspection={inspection} group={group} />;
  // The decision on the finding that is selected is in reach without scrolling.
  const card = useRef<HTMLLIElement>(null);
  useEffect(() => {
    if (selected) card.current?.scrollIntoView({ block: 'start' });
  }, [selected]);
  const picked = ticked === undefined ? { 'aria-expanded': selected } : { role: 'checkbox' as const, 'aria-checked': ticked };
  const pick = () => (ticked === undefined ? show({ ...selectionOf(group), findings: true }) : toggleSeveral(lead.number));
  const maySwipe = selected && !past && ticked === undefined && session.role === 'inspector' && !inspection.closing;
  const swipe = useSwipe(maySwipe, (direction) => void decide(inspection, [group], swiped[direction], decision?.note ?? '', session));
  return (
    <li
      ref={card}
      class={`finding ${selected ? 'selected' : ''} ${decision ? 'decided' : ''} ${maySwipe ? 'swipeable' : ''}`}
      data-testid={`finding-${lead.number}`}
      style={swipe.offset_px === 0 ? undefined : { transform: `translateX(${swipe.offset_px}px)` }}
      {...swipe.handlers}
    >
      {swipe.offset_px !== 0 && (
        <p class={`swipe-verdict ${swipe.offset_px > 0 ? 'right' : 'left'} ${swipe.direction ? 'far' : ''}`} data-testid="swipe-verdict">
          {words.finding.verdicts[swiped[swipe.offset_px > 0 ? 'right' : 'left']]}
        </p>
      )}
      <button type="button" class="row" {...picked} onClick={pick}>
        {ticked !== undefined && (
          <span class="tick-mark" aria-hidden="true">
            {ticked ? '☑' : '☐'}
          </span>
        )}
        <span class={`finding-number ${lead.planned === 'missing' ? 'missing' : lead.kind}`}>
          {group.label}
          <span aria-hidden="true">{marked ? '✎' : signOf(lead)}</span>
        </span>
        <span>
          <strong>{marked ? marked.note || words.review.markedByPerson : whatChanged(lead)}</strong>
          {marked ? <small>{words.review.markedBy(marked.person, timeOf(marked.marked_at))}</small> : lead.planned === 'missing' ? <small>{words.plan.missingHelp}</small> : <SuspicionBar level={level} name={name} />}
          <small>
            {whereAndHow(lead, marked !== undefined)}
            {all.length > 1 && words.review.inViews(all.length)}
          </small>
          <DecisionText group={group} />
        </span>
      </button>
      <Moved groups={groups} group={group} />
      {selected && !past && ticked === undefined && (
        <DecisionForm inspection={inspection} group={group} session={session}>
          {pictures}
        </DecisionForm>
      )}
      {selected && past && pictures}
    </li>
  );
}

// That nothing was found means nothing for what could not be inspected.
function Extent({ inspection, nothing }: { inspection: Inspection; nothing: boolean }) {
  const half = 0.5;
  const least = [...inspection.compared].sort((one, other) => one.judged - other.judged)[0];
  if (!least) return null;
  const { judged, coverage } = least;
  const left_out = coverage.left_out ?? 0;
  const sizes = findableText(leastFindable(inspection.compared));
  const few = judged < half;
  const blind = judged < half * (1 - left_out);
  if (!nothing && !few) return null;
  return (
    <p class={few ? 'bad' : ''} data-testid="extent">
      {few ? '✗ ' : ''}
      <Rich text={(nothing ? words.review.nothing : words.review.inspected)(percentText(judged))} /> {inspection.compared.length > 1 ? words.review.ofWorstView : words.review.ofOneView}
      {left_out > 0 && words.review.leftOutAsAsked(percent(left_out))}
      {sizes && `; ${sizes}`}.{' '}
      {blind ? words.review.blind : words.review.byEye}
    </p>
  );
}

// Clean close-ups, before and after, of a finding of a view; the picture in which a person marked one otherwise.
function Pictures({ inspection, group }: { inspection: Inspection; group: Group }) {
  const { lead, marked } = group;
  const size = useStore(reviewSize);
  if (marked && marked.comparison !== inspection.comparison)
    return <CloseUp after={markedAddress(inspection, marked.number)} size={size} bbox={lead.bbox} />;
  const best = bestSeen(group);
  const address = (moment: string) => pictureAddress(inspection, best.view, `${moment}_color`);
  return (
    <>
      <CloseUp before={address('initial')} after={address('final')} size={size} bbox={best.bbox} />
      {group.all.length > 1 && <small data-testid="close-up-view">{words.review.bestIn(best.view + 1)}</small>}
    </>
  );
}

function FirstLook({ groups }: { groups: Group[] }) {
  const reveal = () => show({ findings: true, uninspected: true, ...(groups[0] ? selectionOf(groups[0]) : {}) });
  return (
    <div class="panel-body">
      <div class="card" data-testid="first-look">
        <h2>{words.review.firstLook}</h2>
        <p>{words.review.firstLookHelp}</p>
        <button type="button" class="primary big" data-testid="reveal" onClick={reveal}>
          {words.review.showFindings}
        </button>
      </div>
    </div>
  );
}

/** @param past whether an earlier round is shown, of which nothing can be changed */
export function FindingList({ inspection, session, past }: { inspection: Inspection; session: Session; past: boolean }) {
  const state = useStore(review);
  const now = useStore(openInspection);
  const groups = groupsOf(inspection);
  const chosen = useStore(several);
  const mayChoose = !past && !inspection.closing && session.role === 'inspector';
  const ticks = mayChoose ? chosen : null;
  const card = (group: Group) => (
    <FindingCard key={group.lead.number} inspection={inspection} groups={groups} group={group} session={session} past={past} selected={group.lead.number === state.group} ticked={ticks?.includes(group.lead.number)} />
  );
  if (!state.findings && state.group === 0) return <FirstLook groups={groups} />;
  return (
    <>
      {/* Without findings, it may scroll while nothing in it can be focused. */}
      <div class="panel-body" {...(groups.length === 0 && { tabIndex: 0 })}>
        <div class="card" data-testid="finding-summary">
          <h2>{words.review.all(groups.length)}</h2>
          <Extent inspection={inspection} nothing={groups.length === 0} />
          {mayChoose && groups.length > 1 && !ticks && (
            <button type="button" data-testid="several" onClick={() => (several.value = [])}>
              {words.review.selectSeveral}
            </button>
          )}
        </div>
        <ul class="list">{groups.filter((group) => !isPlanned(group)).map(card)}</ul>
        <PlannedWork inspection={inspection} groups={groups} session={session} mayDecide={mayChoose} card={card} />
        {!past && <CheckoutCard inspection={inspection} session={session} />}
        {now && <RoundsCard inspection={now} />}
      </div>
      {!past && <UndoBar inspection={inspection} session={session} />}
      {ticks ? <SeveralForm inspection={inspection} groups={groups} session={session} /> : !past && <ClosingCard inspection={inspection} session={session} />}
    </>
  );
}
