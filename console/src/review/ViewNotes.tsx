// What is to be known about the view that the review shows: one line, with the rest on demand.
import { findableText } from '../inspection/words';
import { pictureAddress } from '../link/api';
import { useStore } from '../store';
import type { Inspection } from '../types';
import { CoverageText } from './CoverageText';
import { groupsOf, type Group } from './groups';
import { review } from './review_state';

function viewsOf(group: Group): string {
  const views = [...new Set(group.all.map((finding) => finding.view + 1))];
  return `view ${views.join(' and ')}`;
}

function warningsOf(count: number): string {
  return count === 1 ? '⚠ 1 warning' : `⚠ ${count} warnings`;
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
          Finding {chosen.label} was found in {viewsOf(chosen)} only. That it is not marked here is no evidence against it.
        </p>
      )}
      {compared && (
        <details data-testid="view-notes">
          <summary>
            <span>
              <strong>{Math.round(100 * compared.judged)} %</strong> of {inspection.views.length > 1 ? `view ${view + 1}` : 'this view'} inspected{compared.findable.length > 0 && `; ${findableText(compared.findable)}`}
            </span>
            {compared.warnings.length > 0 && <span class="warn">{warningsOf(compared.warnings.length)}</span>}
          </summary>
          <CoverageText compared={compared} marked={state.findings && state.glow} />
          <img class="wide" loading="lazy" src={pictureAddress(inspection, view, 'level_of_detection')} alt="Smallest height of an object that would have been found at each pixel, with its scale; black could not be judged" />
        </details>
      )}
    </div>
  );
}
