// Findings for tests, with what a test does not state filled in.
import type { Finding } from '../../src/types';

export function finding(number: number, more: Partial<Finding> = {}): Finding {
  return { number, same_as: number, view: 0, kind: 'added', bbox: [0, 0, 1, 1], centroid: [0, 0], evidence: ['depth'], ...more };
}
