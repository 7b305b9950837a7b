// Names and phrases that the console uses.
import type { ComparedView, FindableShare, Finding, InspectionSummary, Levels, LevelsAtDistance } from '../types';
import { decimal, percentText, timeText, words } from '../words/words';

/** By how much narrower than it is an object appears in the depth image (docs/calibrated.md); levels refer to its width in that image. */
const hiddenByDepth_px = 8;

/** The width of the smallest object to which a level applies; undefined if it is not known. */
export function objectWidth_mm({ window_px }: Levels, { width_mm }: LevelsAtDistance): number | undefined {
  return width_mm === undefined ? undefined : (width_mm * (window_px + hiddenByDepth_px)) / window_px;
}

export function titleOf(inspection: InspectionSummary): string {
  const parts = [inspection.aircraft, inspection.zone, inspection.work_order].filter((part) => part !== '');
  return parts.length > 0 ? parts.join(' · ') : words.page.inspection(inspection.id);
}

export function timeOf(iso: string): string {
  return timeText(iso);
}

export function millimetres(value: number): string {
  return `${decimal(value, value < 10 ? 1 : 0)} mm`;
}

/** How significant a change is: the p-value is how often an unchanged bay would show as much. */
export function suspicion(finding: Finding): { level: 1 | 2 | 3; name: string } {
  const certain = 1e-6;
  const likely = 1e-3;
  const [possibly, veryLikely, certainly] = words.finding.suspicions;
  const p = finding.p_value;
  if (p === undefined) return { level: 2, name: words.finding.changed };
  if (p < certain) return { level: 3, name: certainly };
  if (p < likely) return { level: 2, name: veryLikely };
  return { level: 1, name: possibly };
}

export function whatChanged(finding: Finding): string {
  if (finding.planned === 'missing') return words.plan.missingPart(finding.planned_item ?? '');
  if (finding.planned === 'surplus') return words.plan.surplus(words.finding.kinds[finding.kind], finding.planned_item ?? '');
  return words.finding.kinds[finding.kind];
}

/** The name of a class in the person's language; other names are shown as they are. */
export function className(name: string): string {
  const classes: Record<string, string> = words.finding.classes;
  return classes[name] ?? name;
}

/** What the classifier calls it; empty where that is unknown. */
export function likelyClass({ class: name, probability }: Pick<Finding, 'class' | 'probability'>): string {
  if (name === undefined || name === 'unknown' || probability === undefined) return '';
  return words.finding.mayBe(className(name), percentText(probability));
}

/** The character that stands for a finding, beside its number. */
export function signOf({ kind, planned }: Pick<Finding, 'kind' | 'planned'>): string {
  if (planned === 'missing') return '?';
  return { added: '+', removed: '−', appearance: '≈' }[kind];
}

/**
 * Size, distance, and height above the surroundings, or, where that is not known, by how much nearer or farther.
 * @param marked whether a person marked it, so that nothing is known of a change
 */
export function whereAndHow(finding: Finding, marked = false): string {
  const parts: string[] = [];
  if (finding.size_mm) parts.push(`${millimetres(finding.size_mm[0])} × ${millimetres(finding.size_mm[1])}`);
  if (finding.position_m) parts.push(words.finding.away(decimal(finding.position_m[2], 2)));
  if (finding.kind === 'appearance' && !marked) parts.push(words.finding.appearance);
  const change = finding.height_mm;
  const height = finding.above_surroundings_mm;
  const top = finding.top_above_surroundings_mm;
  const { high, highBefore, above, aboveBefore, atEdge, atLeast } = words.finding;
  const removed = finding.kind === 'removed';
  if (top !== undefined) parts.push((removed ? highBefore : high)(finding.top_is_least ? atLeast(millimetres(top)) : millimetres(top)));
  else if (height !== undefined) parts.push((removed ? aboveBefore : above)(millimetres(height)));
  if (finding.background_jump) parts.push(atEdge);
  else if (change !== undefined && height === undefined)
    parts.push(finding.kind === 'added' ? words.finding.nearer(millimetres(Math.abs(change))) : words.finding.farther(millimetres(Math.abs(change))));
  const likely = likelyClass(finding);
  if (likely !== '') parts.push(likely);
  return parts.join(', ');
}

/**
 * "objects of 5 mm would have been found in 76 % of it, of 10 mm in 91 %"; empty if it is not known.
 * @param stated that they would have been found, are expected to be, or would be at best
 */
export function findableText(shares: FindableShare[], stated: keyof typeof words.finding.findable = 'found'): string {
  const [first, ...others] = shares;
  if (!first) return '';
  const rest = others.map((other) => words.finding.findableToo(other.size_mm, percentText(other.share)));
  return `${words.finding.findable[stated](first.size_mm, percentText(first.share))}${rest.join('')}`;
}

/** For each size, the share of the view in which least of it would have been found. */
export function leastFindable(views: Pick<ComparedView, 'findable'>[]): FindableShare[] {
  const [first, ...others] = views.map(({ findable }) => findable);
  return (first ?? []).map(({ size_mm, share }) => ({
    size_mm,
    share: Math.min(share, ...others.map((other) => other.find((one) => one.size_mm === size_mm)?.share ?? 0)),
  }));
}
