// What the inspections of the list showed, by month and by zone: findings by decision, false alarms, time.
import './trends.css';
import { useEffect, useState } from 'preact/hooks';
import { attempt, listFilter, listQuery, wholeList } from '../inspection/inspections';
import { trendsAddress } from '../link/api';
import { useStore } from '../store';
import type { NamedDebris, Trends, VerdictCounts } from '../types';
import { decimal, monthText, words } from '../words/words';
import { MonthChart, type Column } from './MonthChart';
import { monthsOf, type ShownMonth } from './months';
import { followList, nameOf, trends, trendsShown } from './trends';
import { TrendTable } from './TrendTable';

/** From the bottom of a column up. */
const verdicts: (keyof VerdictCounts)[] = ['removed', 'left', 'unreachable', 'installed', 'false_alarms', 'undecided'];
const most_months = 36;

function Legend() {
  return (
    <ul class="chart-legend" aria-label={words.trends.legend}>
      {verdicts.map((verdict) => (
        <li key={verdict}>
          <svg width="16" height="16" aria-hidden="true">
            <rect class={`chart-${verdict}`} width="16" height="16" />
          </svg>
          {nameOf(verdict)}
        </li>
      ))}
    </ul>
  );
}

function Charts({ months }: { months: ShownMonth[] }) {
  const columns = (column: (month: ShownMonth) => Omit<Column, 'month'>): Column[] => months.map((month) => ({ month: month.month, ...column(month) }));
  const one = (value: number | undefined, name: string) => (value === undefined ? [] : [{ name, value, colour: 'chart-value' }]);
  return (
    <>
      <section class="card">
        <h3>{words.trends.findings}</h3>
        <p class="hint">{words.trends.findingsHelp}</p>
        <Legend />
        <MonthChart label={words.trends.findings} places={0} columns={columns(({ trend }) => ({ parts: trend ? verdicts.map((verdict) => ({ name: nameOf(verdict), value: trend.found[verdict], colour: `chart-${verdict}` })) : [] }))} />
      </section>
      <section class="card">
        <h3>{words.trends.falseAlarms}</h3>
        <p class="hint">{words.trends.falseAlarmsHelp}</p>
        <MonthChart
          label={words.trends.falseAlarms}
          places={2}
          columns={columns(({ trend }) => {
            const rate = trend?.false_alarms_per_comparison;
            return { parts: one(rate?.value, words.trends.perComparison), ...(rate && { interval: rate }) };
          })}
        />
      </section>
      <section class="card">
        <h3>{words.trends.time}</h3>
        <p class="hint">{words.trends.timeHelp}</p>
        <MonthChart label={words.trends.time} places={1} columns={columns(({ trend }) => ({ parts: one(trend?.median_hours, words.trends.hours) }))} />
      </section>
    </>
  );
}

function DebrisNames({ debris }: { debris: NamedDebris[] }) {
  if (debris.length === 0) return null;
  const most_first = [...debris].sort((a, b) => b.objects - a.objects);
  return (
    <section class="card">
      <h3>{words.trends.names}</h3>
      <ul class="debris-names">
        {most_first.map(({ name, objects }) => (
          <li key={name}>
            {name || words.trends.unnamed} <strong>{objects}</strong>
          </li>
        ))}
      </ul>
    </section>
  );
}

function Shown({ all }: { all: Trends }) {
  const [picked, setPicked] = useState<string | null>(null);
  const found = all.zones.find(({ zone }) => zone === picked);
  const zone = found ? found.zone : null;
  const sum = found ?? all.sum;
  const months = monthsOf(all, zone, most_months);
  const rate = sum.false_alarms_per_comparison;
  return (
    <>
      <label class="field">
        <span>{words.inspection.zone}</span>
        <select value={zone ?? ''} data-testid="trends-zone" onChange={({ currentTarget }) => setPicked(currentTarget.selectedIndex === 0 ? null : currentTarget.value)}>
          <option value="">{words.trends.allZones(all.zones.length)}</option>
          {all.zones.map(({ zone: name }) => (
            <option key={name} value={name}>
              {name}
            </option>
          ))}
        </select>
      </label>
      <p data-testid="trends-sum">
        {words.trends.sum(sum.inspections, sum.closed, sum.comparisons)}
        {rate && ` ${words.trends.rate(decimal(rate.value, 2), decimal(rate.low, 2), decimal(rate.high, 2))}`}
      </p>
      <Charts months={months} />
      <DebrisNames debris={sum.debris} />
      <TrendTable caption={words.trends.byMonth} of={words.trends.month} rows={months.flatMap(({ month, trend }) => (trend ? [{ key: month, name: monthText(month), trend }] : []))} />
      <TrendTable caption={words.trends.byZone} of={words.inspection.zone} rows={all.zones.map((trend) => ({ key: trend.zone, name: trend.zone, trend }))} onPick={({ key }) => setPicked(key)} />
    </>
  );
}

export function TrendsPage() {
  const all = useStore(trends);
  const filtered = useStore(listFilter) !== wholeList;
  useEffect(() => followList((error) => void attempt(() => Promise.reject(error))), []);
  return (
    <div class="trends" data-testid="trends">
      <div class="trends-head">
        <h2>{words.trends.title}</h2>
        {all && all.sum.inspections > 0 && (
          <a class="button" href={trendsAddress('.csv', listQuery())} download="trends.csv" data-testid="trends-csv">
            {words.trends.csv}
          </a>
        )}
        <button type="button" data-testid="trends-close" onClick={() => (trendsShown.value = false)}>
          {words.trends.livePicture}
        </button>
      </div>
      {filtered && <p class="hint">{words.trends.filtered}</p>}
      {all === null && <p class="hint">{words.page.loading}</p>}
      {all?.sum.inspections === 0 && <p class="hint">{filtered ? words.inspection.noneMatches : words.inspection.none}</p>}
      {all && all.sum.inspections > 0 && <Shown all={all} />}
    </div>
  );
}
