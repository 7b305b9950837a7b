// What a measurement states, in words.
import type { Measurement, ProfileSample } from '../types';
import { percentText, words } from '../words/words';
import { quantityText } from './quantity';

export type Measured = Required<Pick<ProfileSample, 'share' | 'along_mm' | 'height_mm' | 'height_uncertainty_mm'>>;

/** The samples of a profile without its gaps. */
export function measuredSamples(profile: ProfileSample[]): Measured[] {
  return profile.filter((sample): sample is Measured => sample.height_mm !== undefined);
}

/** The share of a profile that could not be measured, 0 to 1. */
export function gapShare(profile: ProfileSample[]): number {
  return 1 - measuredSamples(profile).length / profile.length;
}

function profileText(profile: ProfileSample[]): string {
  const samples = measuredSamples(profile);
  if (samples.length === 0) return words.measure.nothing;
  const highest = samples.reduce((best, sample) => (sample.height_mm > best.height_mm ? sample : best));
  const lowest = samples.reduce((best, sample) => (sample.height_mm < best.height_mm ? sample : best));
  const gaps = gapShare(profile);
  const text = words.measure.profile(quantityText(highest.height_mm, highest.height_uncertainty_mm), quantityText(lowest.height_mm, lowest.height_uncertainty_mm));
  return gaps > 0 ? text + words.measure.gaps(percentText(Math.max(0.01, gaps))) : text;
}

function valueText(measurement: Measurement): string {
  const { tool, points, height_mm, height_uncertainty_mm = 0, length_mm, length_uncertainty_mm = 0, profile } = measurement;
  if (tool === 'height' && height_mm !== undefined)
    return (height_mm < 0 ? words.measure.below : words.measure.above)(quantityText(Math.abs(height_mm), height_uncertainty_mm));
  if (profile) return profileText(profile);
  if (length_mm !== undefined) return quantityText(length_mm, length_uncertainty_mm);
  const [point] = points;
  return point ? quantityText(1000 * point.distance_m, point.distance_uncertainty_mm ?? 0) : '';
}

/** What was measured, or why nothing was. */
export function resultText(measurement: Measurement): string {
  if (measurement.problem) return measurement.problem;
  const nearEdge = measurement.points.some((point) => point?.near_edge);
  return valueText(measurement) + (nearEdge ? words.measure.nearEdge : '');
}

/** The same without remarks, for the picture. */
export function labelText(measurement: Measurement): string {
  return measurement.problem ?? valueText(measurement);
}
