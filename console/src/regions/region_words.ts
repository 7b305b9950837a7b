// Shares of a picture that are left out.
import { percentText, words } from '../words/words';

export function percent(share: number): string {
  return Math.round(100 * share) === 0 && share > 0 ? words.regions.lessThan1 : percentText(share);
}
