// What a measurement states, in words.
import type { Measurement, ProfileSample } from '../types';
import { percentText, sentence, words } from '../words/words';
import { quantityText } from './quantity';

export type Measured = Required<Pick<ProfileSample, 'share' | 'along_mm' | 'height_mm' | 'height_uncertainty_mm'>>;

/**
 * The samples of a profile without its gaps. Where the uncertainty is many times that of the profile, the camera
 * mistook the surface, as it does at edges: that is no height of this profile.
 */
export function measuredSamples(profile: ProfileSample[]): Measured[] {
  const timesUsual = 10;
  const measured = profile.filter((sample): sample is Measured => sample.height_mm !== undefined);
  const uncertainties = measured.map((sample) => sample.height_uncertainty_mm).sort((a, b) => a - b);
  const median = uncertainties[Math.floor(uncertainties.length / 2)] ?? 0;
  return measured.filter((sample) => sample.height_uncertainty_mm <= timesUsual * median);
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

function problemText({ unmeasured, problem }: Measurement): string | undefined {
  if (!unmeasured) return problem;
  const part = words.measure.unmeasuredParts[unmeasured.part](unmeasured.point ?? 0);
  return sentence(words.measure.unmeasured[unmeasured.reason](part));
}

/** What was measured, or why nothing was. */
export function resultText(measurement: Measurement): string {
  const problem = problemText(measurement);
  if (problem) return problem;
  const nearEdge = measurement.points.some((point) => point?.near_edge);
  return valueText(measurement) + (nearEdge ? words.measure.nearEdge : '');
}

/** The same without remarks, for the picture. */
export function labelText(measurement: Measurement): string {
  return problemText(measurement) ?? valueText(measurement);
}
