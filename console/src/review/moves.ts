// Objects that were probably moved: something removed, and something new of about its size elsewhere.
import type { Group } from './groups';

function numbersOf(group: Group): number[] {
  return group.all.map((finding) => finding.number);
}

/** Of something new: where it may have been before. */
export function movedFrom(groups: Group[], group: Group): Group | undefined {
  const origins = group.all.map((finding) => finding.moved_from);
  return groups.find((other) => other !== group && numbersOf(other).some((number) => origins.includes(number)));
}

/** Of something that was removed: where it may be now. */
export function movedTo(groups: Group[], group: Group): Group[] {
  return groups.filter((other) => movedFrom(groups, other) === group);
}
