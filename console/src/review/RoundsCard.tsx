// All rounds of an inspection: what each of them found, and what was decided.
import { useEffect, useState } from 'preact/hooks';
import { timeOf } from '../inspection/words';
import { api } from '../link/api';
import { useStore } from '../store';
import type { Inspection, Round } from '../types';
import { groupsOf } from './groups';
import { asItWas, earlierRound, numbered, showRound, type NumberedRound } from './rounds';
import { words } from '../words/words';

/** "3 findings: 2 debris removed, 1 false alarm". */
export function outcomeOf(inspection: Inspection, round: Round): string {
  const groups = groupsOf(asItWas(inspection, round));
  if (groups.length === 0) return words.review.nothingFound;
  const count = (...verdicts: string[]) => groups.filter((group) => verdicts.includes(group.lead.decision?.verdict ?? '')).length;
  const parts = [
    [count('debris-removed'), words.review.outcome.removed],
    [count('debris', 'debris-unreachable'), words.review.outcome.left],
    [count('installed-work'), words.review.outcome.installed],
    [count('false-alarm'), words.review.outcome.falseAlarms],
    [count('second-look', ''), words.review.outcome.undecided],
  ] as const;
  const named = parts.filter(([number]) => number > 0).map(([number, name]) => name(number));
  return `${words.review.all(groups.length)}: ${named.join(', ')}`;
}

/** @param inspection as it is now */
export function RoundsCard({ inspection }: { inspection: Inspection }) {
  const [rounds, setRounds] = useState<NumberedRound[]>([]);
  const shown = useStore(earlierRound);
  useEffect(() => {
    let current = true;
    api.rounds(inspection.id).then(
      (answer) => current && setRounds(numbered(answer.rounds)),
      () => undefined,
    );
    return () => {
      current = false;
    };
  }, [inspection]);
  if (rounds.length < 2) return null;
  return (
    <div class="card" data-testid="rounds">
      <h2>{words.review.rounds}</h2>
      <ul class="list">
        {rounds.map((round) => {
          const isCurrent = round.comparison === inspection.comparison;
          const isShown = shown ? shown.comparison === round.comparison : isCurrent;
          return (
            <li key={round.comparison}>
              <button type="button" class="row" aria-pressed={isShown} data-testid={`round-${round.number}`} onClick={() => showRound(round)}>
                <strong>
                  {words.review.round(round.number)}
                  {isCurrent && ` ${words.review.roundNow}`}
                </strong>
                <span>{outcomeOf(inspection, round)}</span>
                <small>
                  {round.final ? `${round.final.person}, ` : ''}
                  {timeOf(round.compared_at)}
                </small>
              </button>
            </li>
          );
        })}
      </ul>
    </div>
  );
}
