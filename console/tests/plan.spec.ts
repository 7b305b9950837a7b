// Planned work: drawn on the baseline before the work, and decided on together after it.
import { expectAccessible, expectTouchable } from './accessibility';
import { inspectionOf, standIn } from './region_page';
import { begin, expect, test } from './served';
import type { Inspection, Plan, PlanRequest } from '../src/types';

const taken = { taken_at: '2025-01-01T10:00:00Z', person: 'Ann', base: 'b1', round: 1 };
const ahead = { pan_deg: 0, tilt_deg: -20 };

test('an area is drawn, described and sent; a plan file is loaded; a part is removed', async ({ console: page }) => {
  await begin(page);
  await standIn(page, { stage: 'work', initial: taken, views: [ahead] });
  const asked: string[] = [];
  const inspection = await inspectionOf(page);
  let views: Inspection['views'] = [ahead];
  // The console loads the inspection again when a check ends.
  await page.route('**/api/inspections/1', (route) => route.fulfill({ json: { ...inspection, views } }));
  await page.route('**/api/inspections/1/views/0/plan', (route) => {
    const { text } = route.request().postDataJSON() as PlanRequest;
    asked.push(text);
    views = [{ ...ahead, ...(text.startsWith('{') && { plan: JSON.parse(text) as Plan }) }];
    return route.fulfill({ json: { ...inspection, views } });
  });
  await page.getByTestId('page-plan').click();
  await expect(page.getByTestId('plan-parts')).toContainText('Nothing is planned');
  await page.getByTestId('plan-draw').click();
  await expectAccessible(page);
  const box = (await page.getByTestId('picture').boundingBox())!;
  const at = (u: number, v: number): [number, number] => [box.x + ((u + 0.5) / 848) * box.width, box.y + ((v + 0.5) / 480) * box.height];
  await page.mouse.move(...at(100, 200));
  await page.mouse.down();
  await page.mouse.move(...at(300, 250));
  await page.mouse.move(...at(500, 300));
  await page.mouse.up();

  await expect(page.getByTestId('part-form')).toBeVisible();
  await expectTouchable(page);
  await expectAccessible(page);
  await page.getByTestId('part-name').fill('collars in row 3');
  await page.getByTestId('part-count').fill('24');
  await page.getByTestId('part-height-from').fill('8');
  await page.getByTestId('part-height-to').fill('10');
  await page.getByTestId('part-save').click();
  await expect(page.getByTestId('plan-parts')).toContainText('24 × collars in row 3');
  await expect(page.getByTestId('plan-shape-collars in row 3')).toContainText('24 × collars in row 3');
  const [part] = (JSON.parse(asked[0]!) as Plan).parts;
  expect(part).toMatchObject({ name: 'collars in row 3', kind: 'added', count: 24, height_mm: [8, 10] });
  const [[left, top], , [right, bottom]] = part!.areas[0] as [number[], number[], number[]] as [[number, number], number[], [number, number]];
  expect(Math.abs(left - 99.5) + Math.abs(top - 199.5) + Math.abs(right - 500.5) + Math.abs(bottom - 300.5)).toBeLessThan(8);

  await page.getByTestId('plan-remove-collars in row 3').click();
  await expect(page.getByTestId('plan-parts')).toContainText('Nothing is planned');
  expect(asked[1], 'an empty plan is none').toBe('');
  const file = { format: 'rva-plan', version: 1, coordinates: 'metres', parts: [{ name: 'nuts', kind: 'removed', count: 3, areas: [], tolerance_mm: 10 }] };
  await page.getByTestId('plan-file').setInputFiles({ name: 'plan.json', mimeType: 'application/json', buffer: Buffer.from(JSON.stringify(file)) });
  await expect(page.getByTestId('plan-parts')).toContainText('3 × nuts');
  await expect(page.getByTestId('plan-draw'), 'metres are not drawn').toBeDisabled();
  await expectTouchable(page);
});

const finding = { same_as: 1, number: 1, view: 0, kind: 'added', bbox: [100, 100, 20, 20], centroid: [110, 110], evidence: ['depth'] };
const nth = (number: number, part: object) => ({ ...finding, number, same_as: number, bbox: [60 * number, 100, 20, 20], ...part });

test('what was not planned comes first, what is missing is a finding, and planned parts are decided on together', async ({ console: page }) => {
  await begin(page);
  await standIn(page, {
    stage: 'review', initial: taken, final: taken, comparison: 1, compared_at: taken.taken_at, views: [ahead], marked: [],
    compared: [{ view: 0, method: 'calibrated', judged: 0.7, warnings: [], findable: [], coverage: { compared: 0.7, unseen: 0.1, invalid: 0.2 },
      planned: [{ name: 'collars', kind: 'added', planned: 3, found: 2, missing: 1, not_inspected: 0 }] }],
    findings: [nth(1, { planned: 'unplanned' }), nth(2, { planned: 'missing', planned_item: 'collars', evidence: [] }), nth(3, { planned: 'planned', planned_item: 'collars' }),
      nth(4, { planned: 'planned', planned_item: 'collars' })] as unknown as Inspection['findings'],
  });
  await page.getByTestId('reveal').click();
  await expect(page.getByTestId('finding-1')).toBeVisible();
  await expect(page.getByTestId('finding-2')).toContainText('Missing: collars');
  await expect(page.getByTestId('finding-3'), 'listed with the others of its part').toHaveCount(0);
  await expect(page.getByTestId('box-2')).toHaveClass(/missing/);
  const work = page.getByTestId('planned-collars');
  await expect(work).toContainText('2 of 3 collars');
  await expect(work).toContainText('1 missing');
  await expect(page.getByTestId('planned-decide-collars'), 'only after a look').toHaveCount(0);
  await page.getByTestId('planned-show-collars').click();
  await expect(page.getByTestId('finding-4')).toBeVisible();
  await expectTouchable(page);
  await expectAccessible(page);
  const asked = page.waitForRequest('**/api/inspections/1/decisions');
  await page.route('**/api/inspections/1/decisions', async (route) => route.fulfill({ json: await inspectionOf(page) }));
  await page.getByTestId('planned-decide-collars').click();
  expect((await asked).postDataJSON()).toMatchObject({
    decisions: [3, 4].map((number) => ({ finding: number, verdict: 'installed-work', note: '' })),
  });
});
