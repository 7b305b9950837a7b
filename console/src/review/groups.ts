// Groups of findings that show the same object in several views.
import type { Decision, Finding, Inspection } from '../types';

export interface Group {
  /** Its position in the list, from 1, shown to the user as its number. */
  label: number;
  /** The most suspicious finding of the group; its number identifies the group to the server. */
  lead: Finding;
  all: Finding[];
}

/** The groups of an inspection's findings, most suspicious first. */
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
