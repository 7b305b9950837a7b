// What is to be known about the view that the review shows: one line, with the rest on demand.
import { findableText } from '../inspection/words';
import { pictureAddress } from '../link/api';
import { useStore } from '../store';
import type { Inspection } from '../types';
import { CoverageText } from './CoverageText';
import { groupsOf, type Group } from './groups';
import { review } from './review_state';
import { Rich } from '../words/Rich';
import { percentText, words } from '../words/words';

function viewsOf(group: Group): number[] {
  return [...new Set(group.all.map((finding) => finding.view + 1))];
}

export function ViewNotes({ inspection }: { inspection: Inspection }) {
  const state = useStore(review);
  const view = Math.min(state.view, inspection.views.length - 1);
  const compared = inspection.compared.find((one) => one.view === view);
  const chosen = groupsOf(inspection).find((group) => group.lead.number === state.group);
  return (
    <div class="view-notes">
      {chosen && chosen.lead.view >= 0 && !chosen.all.some((finding) => finding.view === view) && (
        <p class="coverage" data-testid="not-here">
          {words.review.notHere(chosen.label, viewsOf(chosen))}
        </p>
      )}
      {compared && (
        <details data-testid="view-notes">
          <summary>
            <span>
              <Rich text={inspection.views.length > 1 ? words.review.ofView(percentText(compared.judged), view + 1) : words.review.ofThisView(percentText(compared.judged))} />
              {compared.findable.length > 0 && `; ${findableText(compared.findable)}`}
            </span>
            {compared.warnings.length > 0 && <span class="warn">{words.review.warnings(compared.warnings.length)}</span>}
          </summary>
          <CoverageText compared={compared} marked={state.findings && state.glow} />
          <img class="wide" loading="lazy" src={pictureAddress(inspection, view, 'level_of_detection')} alt={words.review.levelPicture} />
        </details>
      )}
    </div>
  );
}
