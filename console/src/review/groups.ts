// Findings of several views that are one thing, as one.
import type { Decision, Finding, Inspection } from '../types';

export interface Group {
  /** Its place in the list, from 1: what a person calls it. */
  label: number;
  /** The most suspicious finding of the thing; its number is the group's for the server. */
  lead: Finding;
  all: Finding[];
}

/** Most suspicious first. */
export function groupsOf(inspection: Inspection): Group[] {
  const groups = new Map<number, Group>();
  for (const finding of inspection.findings) {
    const group = groups.get(finding.same_as);
    if (group) group.all.push(finding);
    else groups.set(finding.same_as, { label: groups.size + 1, lead: finding, all: [finding] });
  }
  return [...groups.values()];
}

export function decisionOf(group: Group): Decision | undefined {
  return group.lead.decision;
}
