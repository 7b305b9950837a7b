// Heights along a line, with their uncertainty as a band; gaps stay empty.
import type { ProfileSample } from '../types';
import { measuredSamples, type Measured } from './result';
import { words } from '../words/words';

const width = 600;
const height = 120;
/** The chart shows at least this range of heights, so that noise does not look like steps. */
const least_mm = 4;

// Samples that follow each other without a gap.
function pieces(profile: ProfileSample[], measured: Measured[]): Measured[][] {
  const all: Measured[][] = [[]];
  for (const sample of profile) {
    const found = measured.find((one) => one === sample);
    if (found) all.at(-1)!.push(found);
    else all.push([]);
  }
  return all.filter((piece) => piece.length > 0);
}

export function ProfileChart({ profile }: { profile: ProfileSample[] }) {
  const samples = measuredSamples(profile);
  if (samples.length === 0) return null;
  const tops = samples.map((sample) => sample.height_mm + sample.height_uncertainty_mm);
  const bottoms = samples.map((sample) => sample.height_mm - sample.height_uncertainty_mm);
  const middle = (Math.max(...tops) + Math.min(...bottoms)) / 2;
  const range = Math.max(least_mm, Math.max(...tops) - Math.min(...bottoms));
  const x = (sample: Measured) => sample.share * width;
  const y = (mm: number) => height / 2 - ((mm - middle) / range) * (height - 10);
  const line = (piece: Measured[]) => piece.map((sample) => `${x(sample).toFixed(1)},${y(sample.height_mm).toFixed(1)}`).join(' ');
  const band = (piece: Measured[]) =>
    [...piece.map((sample) => [x(sample), y(sample.height_mm + sample.height_uncertainty_mm)]), ...[...piece].reverse().map((sample) => [x(sample), y(sample.height_mm - sample.height_uncertainty_mm)])]
      .map(([u, v]) => `${u!.toFixed(1)},${v!.toFixed(1)}`)
      .join(' ');
  return (
    <svg class="profile-chart" viewBox={`0 0 ${width} ${height}`} preserveAspectRatio="none" role="img" aria-label={words.measure.chart} data-testid="profile">
      {pieces(profile, samples).map((piece) => (
        <g key={piece[0]!.share}>
          <polygon class="profile-band" points={band(piece)} />
          <polyline class="profile-line" points={line(piece)} />
        </g>
      ))}
      <line class="profile-zero" x1="0" x2={width} y1={y(0)} y2={y(0)} />
    </svg>
  );
}
