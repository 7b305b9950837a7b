// Groups of findings that show the same object in several views.
import type { Decision, Finding, Inspection, MarkedFinding } from '../types';

export interface Group {
  /** Its position in the list, from 1, shown to the user as its number. */
  label: number;
  /** The most suspicious finding of the group. Its number identifies the group, to the server as well. */
  lead: Finding;
  all: Finding[];
  /** Only of a finding that a person marked. */
  marked?: MarkedFinding;
}

/** A marked finding as one of the comparison. Its number is negative, and its view is -1 in the live picture. */
function asFinding(marked: MarkedFinding): Finding {
  const [u, v, width, height] = marked.bbox;
  return {
    number: -marked.number,
    same_as: -marked.number,
    view: marked.view ?? -1,
    kind: 'appearance',
    bbox: marked.bbox,
    centroid: [u + (width - 1) / 2, v + (height - 1) / 2],
    evidence: [],
    ...(marked.position_m && { position_m: marked.position_m }),
    ...(marked.size_mm && { size_mm: marked.size_mm }),
    ...(marked.decision && { decision: marked.decision }),
  };
}

/** The groups of an inspection's findings, most suspicious first, and then what people marked. */
export function groupsOf(inspection: Inspection): Group[] {
  const groups = new Map<number, Group>();
  for (const finding of inspection.findings) {
    const group = groups.get(finding.same_as);
    if (group) group.all.push(finding);
    else groups.set(finding.same_as, { label: groups.size + 1, lead: finding, all: [finding] });
  }
  for (const marked of inspection.marked) {
    const lead = asFinding(marked);
    groups.set(lead.number, { label: groups.size + 1, lead, all: [lead], marked });
  }
  return [...groups.values()];
}

/** The finding of a group whose view shows the object best; the lead where this is not known. */
export function bestSeen({ lead, all }: Group): Finding {
  return all.reduce((best, one) => ((one.clear_px ?? 0) > (best.clear_px ?? 0) ? one : best), lead);
}

export function decisionOf(group: Group): Decision | undefined {
  return group.lead.decision;
}

/** Whether nothing remains to be done about a finding; as the server counts it. */
export function isSettled(group: Group): boolean {
  const verdict = decisionOf(group)?.verdict;
  return verdict !== undefined && verdict !== 'second-look' && verdict !== 'debris';
}

/** The next finding without a decision after this one; the list is searched to its end and then from its beginning. */
export function nextUndecided(groups: Group[], after: number): Group | undefined {
  const at = groups.findIndex((group) => group.lead.number === after);
  return [...groups.slice(at + 1), ...groups.slice(0, at + 1)].find((group) => !decisionOf(group));
}
