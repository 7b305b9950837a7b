// A review that needs no captures, for tests.
import type { Page } from '@playwright/test';
import type { Finding, Inspection } from '../src/types';
import { standIn } from './region_page';
import { begin, expect } from './served';

const taken = { taken_at: '2025-01-01T12:00:00Z', person: 'Ann' } as NonNullable<Inspection['initial']>;
const ahead = { pan_deg: 0, tilt_deg: -20 };
const finding = { centroid: [120, 115], same_as: 1, number: 1, view: 0, kind: 'added', bbox: [100, 100, 40, 30] };

/**
 * A review of two views, with two findings of which one is in both, and pictures of one colour.
 * @param awaitFirstLook whether it returns once the page shows the first look
 * @param known what the server states of each finding besides
 */
export async function openReview(page: Page, awaitFirstLook = true, known: Partial<Finding> = {}): Promise<void> {
  await begin(page);
  await standIn(page, {
    stage: 'review', initial: taken, final: taken, comparison: 1, compared_at: taken.taken_at, views: [ahead, ahead],
    compared: [0, 1].map((view) => ({ view, method: 'calibrated', judged: 0.7, warnings: [], findable: [{ size_mm: 5, share: 0.4 }, { size_mm: 10, share: 0.7 }], coverage: { compared: 0.7, unseen: 0.1, invalid: 0.2 } })),
    findings: [{ ...finding, clear_px: 300 }, { ...finding, number: 2, view: 1, bbox: [600, 300, 40, 30], clear_px: 800 }, { ...finding, number: 3, same_as: 3, kind: 'removed', bbox: [400, 200, 300, 200] }].map((one) => ({ ...one, ...known })) as unknown as Inspection['findings'],
    marked: [],
  });
  if (awaitFirstLook) await expect(page.getByTestId('first-look')).toBeVisible();
}

/** The map of a wall, 0.6 m in front of the foot, as an ASCII file. */
export function wall(): string {
  const points: string[] = [];
  for (let x = -0.15; x <= 0.15; x += 0.003) for (let z = -0.1; z <= 0.1; z += 0.003) points.push(`${x.toFixed(4)} 0.6 ${z.toFixed(4)} 120 130 140`);
  const properties = ['float x', 'float y', 'float z', 'uchar red', 'uchar green', 'uchar blue'].map((name) => `property ${name}`);
  return ['ply', 'format ascii 1.0', `element vertex ${points.length}`, ...properties, 'end_header', ...points, ''].join('\n');
}
