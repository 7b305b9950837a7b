// A column for each month: of parts upon each other, or one value with its interval.
import { useLayoutEffect, useRef } from 'preact/hooks';
import { decimal, monthText } from '../words/words';
import { roundedUp } from './months';

export interface Part {
  name: string;
  value: number;
  /** Class of the colour. */
  colour: string;
}

export interface Column {
  month: string;
  parts: Part[];
  interval?: { low: number; high: number };
}

const column_px = 52;
const axis_px = 44;
const height_px = 150;
const top_px = 8;
const labels_px = 40;
/** The least end of the scale, by decimal places. */
const least = [2, 1, 0.1] as const;

function totalOf({ parts }: Column): number {
  return parts.reduce((sum, part) => sum + part.value, 0);
}

function MonthLabel({ month, x }: { month: string; x: number }) {
  const [name = '', year = ''] = monthText(month).split(' ');
  return (
    <text class="chart-text" x={x} y={top_px + height_px + 16} text-anchor="middle">
      <tspan x={x}>{name}</tspan>
      <tspan x={x} dy="15">
        {year}
      </tspan>
    </text>
  );
}

// Parts from the bottom up.
function Stack({ column, x, y }: { column: Column; x: number; y: (value: number) => number }) {
  let below = 0;
  return (
    <>
      {column.parts.map(({ name, value, colour }) => {
        const base = below;
        below += value;
        return (
          <rect key={name} class={colour} x={x + 9} width={column_px - 18} y={y(below)} height={y(base) - y(below)}>
            <title>{`${monthText(column.month)}: ${name} ${decimal(value, Number.isInteger(value) ? 0 : 2)}`}</title>
          </rect>
        );
      })}
    </>
  );
}

function Axis({ labels }: { labels: { y: number; text: string }[] }) {
  return (
    <svg class="chart-axis" width={axis_px} height={top_px + height_px + labels_px} aria-hidden="true">
      {labels.map(({ y, text }) => (
        <text key={text} class="chart-text" x={axis_px - 8} y={y + 4} text-anchor="end">
          {text}
        </text>
      ))}
    </svg>
  );
}

/** The values are in the tables below: a picture of them needs a name alone. The axis stays while the months scroll. */
export function MonthChart({ label, columns, places }: { label: string; columns: Column[]; places: 0 | 1 | 2 }) {
  const scroller = useRef<HTMLDivElement>(null);
  // The last month is what people look for first.
  useLayoutEffect(() => scroller.current?.scrollTo({ left: scroller.current.scrollWidth }), [columns.length]);
  const most = roundedUp(Math.max(least[places], ...columns.map((column) => Math.max(totalOf(column), column.interval?.high ?? 0))));
  const y = (value: number) => top_px + height_px * (1 - value / most);
  const ticks = places === 0 && most % 2 === 1 ? [0, most] : [0, most / 2, most];
  const width = columns.length * column_px;
  return (
    <div class="month-chart">
      <Axis labels={ticks.map((value) => ({ y: y(value), text: decimal(value, places) }))} />
      <div class="month-columns" ref={scroller} tabIndex={0} role="group" aria-label={label}>
        <svg width={width} height={top_px + height_px + labels_px} role="img" aria-label={label}>
          {ticks.map((value) => (
            <line key={value} class="chart-line" x1="0" x2={width} y1={y(value)} y2={y(value)} />
          ))}
          {columns.map((column, index) => {
            const x = index * column_px;
            return (
              <g key={column.month}>
                <Stack column={column} x={x} y={y} />
                {column.interval && <path class="chart-interval" d={`M${x + column_px / 2 - 6},${y(column.interval.high)}h12m-6,0V${y(column.interval.low)}m-6,0h12`} />}
                <MonthLabel month={column.month} x={x + column_px / 2} />
              </g>
            );
          })}
        </svg>
      </div>
    </div>
  );
}
