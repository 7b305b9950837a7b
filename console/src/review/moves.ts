// Objects that may have been moved: one that was removed, and one of about its size that was added elsewhere.
import type { Group } from './groups';

function numbersOf(group: Group): number[] {
  return group.all.map((finding) => finding.number);
}

/** For an added finding: the group where it may have been before. */
export function movedFrom(groups: Group[], group: Group): Group | undefined {
  const origins = group.all.map((finding) => finding.moved_from);
  return groups.find((other) => other !== group && numbersOf(other).some((number) => origins.includes(number)));
}

/** For a removed finding: the groups where it may be now. */
export function movedTo(groups: Group[], group: Group): Group[] {
  return groups.filter((other) => movedFrom(groups, other) === group);
}
