// Trends as numbers, a row each.
import type { Trend } from '../types';
import { decimal, words } from '../words/words';
import { nameOf } from './trends';

export interface Row {
  key: string;
  name: string;
  trend: Trend;
}

function debrisIn({ found, marked }: Trend): number {
  return [found, marked].reduce((sum, counts) => sum + counts.removed + counts.left + counts.unreachable, 0);
}

function rateIn({ false_alarms_per_comparison: rate }: Trend): string {
  return rate ? words.trends.interval(decimal(rate.value, 2), decimal(rate.low, 2), decimal(rate.high, 2)) : '–';
}

/** @param onPick makes names buttons */
export function TrendTable({ caption, of, rows, onPick }: { caption: string; of: string; rows: Row[]; onPick?: (row: Row) => void }) {
  return (
    <div class="trend-table" tabIndex={0} role="group" aria-label={caption}>
      <table>
        <caption>{caption}</caption>
        <thead>
          <tr>
            <th scope="col">{of}</th>
            <th scope="col">{words.inspection.inspections}</th>
            <th scope="col">{words.trends.debris}</th>
            <th scope="col">{nameOf('installed')}</th>
            <th scope="col">{nameOf('false_alarms')}</th>
            <th scope="col">{words.trends.perComparison}</th>
            <th scope="col">{words.trends.hours}</th>
          </tr>
        </thead>
        <tbody>
          {rows.map((row) => (
            <tr key={row.key}>
              <th scope="row">
                {onPick ? (
                  <button type="button" class="quiet" onClick={() => onPick(row)}>
                    {row.name}
                  </button>
                ) : (
                  row.name
                )}
              </th>
              <td>{row.trend.inspections}</td>
              <td>{debrisIn(row.trend)}</td>
              <td>{row.trend.found.installed}</td>
              <td>{row.trend.found.false_alarms}</td>
              <td>{rateIn(row.trend)}</td>
              <td>{row.trend.median_hours === undefined ? '–' : decimal(row.trend.median_hours, 1)}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}
