// How much of a view was inspected, why the rest was not, and the warnings of the comparison.
import { percent } from '../regions/region_words';
import type { ComparedView } from '../types';

function sentence(text: string): string {
  return `${text.charAt(0).toUpperCase()}${text.slice(1)}${text.endsWith('.') ? '' : '.'}`;
}

/** @param marked whether findings are marked in the picture */
export function CoverageText({ compared, marked }: { compared: ComparedView; marked: boolean }) {
  const { judged, coverage, warnings } = compared;
  return (
    <>
      {warnings.map((warning) => (
        <p class="coverage bad" role="status" data-testid="view-warning" key={warning}>
          <span aria-hidden="true">⚠ </span>
          {sentence(warning)}
        </p>
      ))}
      <p class="coverage" data-testid="coverage">
        <strong>{Math.round(100 * judged)} %</strong> of this view was inspected. <span class="stripes" aria-hidden="true" /> <strong>{Math.round(100 * (1 - judged))} %</strong> was not:{' '}
        {coverage.left_out !== undefined && coverage.left_out > 0 && `${percent(coverage.left_out)} was left out as asked; elsewhere `}
        the camera measured no depth ({Math.round(100 * coverage.invalid)} %), the baseline did not show it ({Math.round(100 * coverage.unseen)} %), or it is an edge or too noisy.
        {marked && (
          <>
            {' '}
            <span class="changed-mark" aria-hidden="true" /> Changed.
          </>
        )}{' '}
        Grey in colour pictures: beyond the colour camera's view.
      </p>
    </>
  );
}
