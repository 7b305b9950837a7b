// How much of a view was inspected, why the rest was not, and the warnings of the comparison.
import { percent } from '../regions/region_words';
import type { ComparedView } from '../types';
import { Rich } from '../words/Rich';
import { percentText, sentence, words } from '../words/words';

/** @param marked whether findings are marked in the picture */
export function CoverageText({ compared, marked }: { compared: ComparedView; marked: boolean }) {
  const { judged, coverage, warnings } = compared;
  return (
    <>
      {warnings.map((warning) => (
        <p class="coverage bad" role="status" data-testid="view-warning" key={warning}>
          <span aria-hidden="true">⚠ </span>
          {sentence(warning.endsWith('.') ? warning : `${warning}.`)}
        </p>
      ))}
      <p class="coverage" data-testid="coverage">
        <Rich text={words.review.inspectedInView(percentText(judged))} /> <span class="stripes" aria-hidden="true" /> <Rich text={words.review.notInspectedShare(percentText(1 - judged))} />{' '}
        {coverage.left_out !== undefined && coverage.left_out > 0 && `${words.review.leftOut(percent(coverage.left_out))} `}
        {words.review.notMeasured(percentText(coverage.invalid), percentText(coverage.unseen))} {words.review.edge}
        {marked && (
          <>
            {' '}
            <span class="changed-mark" aria-hidden="true" /> {words.review.changedEnd}
          </>
        )}{' '}
        {words.review.colorless}
      </p>
    </>
  );
}
