// Texts about regions that are left out.

export const purpose =
  'Regions that you draw are not compared. Use them for objects that move or change by themselves, such as a hose or a lamp; they count as left out in the coverage, not as inspected.';

export const comparedAlready =
  'This inspection has already been compared. After saving, the comparison must be made again; decisions on its findings stay in the record but do not carry over.';

export function percent(share: number): string {
  const whole = Math.round(100 * share);
  return whole === 0 && share > 0 ? 'less than 1 %' : `${whole} %`;
}

export function regionCount(count: number): string {
  return count === 0 ? 'no regions' : count === 1 ? '1 region' : `${count} regions`;
}
