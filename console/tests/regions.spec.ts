// Parts of a view that are left out of the comparison.
import { expectAccessible, expectTouchable } from './accessibility';
import { cornersOf, drag, inspectionOf, onScreen, openEditor, standIn } from './region_page';
import { begin, expect, test } from './served';
import type { Corner, Inspection } from '../src/types';

const capture_ms = 90_000;
const baseline = { taken_at: '2025-01-01T10:00:00Z', person: 'Ann', base: 'b1', round: 1 };
const ahead = { pan_deg: 0, tilt_deg: -20 };

test('what is drawn over is not compared, outlasts a reload and counts as left out', async ({ console: page }) => {
  await begin(page);
  await page.getByTestId('capture-initial').click();
  await expect(page.getByTestId('regions-card')).toContainText('Nothing is left out', { timeout: capture_ms });
  await page.getByTestId('simulate-work').click();
  await page.getByTestId('capture-final').click();
  await page.getByTestId('reveal').click({ timeout: capture_ms });
  await expect(page.getByTestId('coverage')).not.toContainText('left out');

  const before = await inspectionOf(page);
  const [x, y, width, height] = before.findings[0]!.bbox;
  const margin = 12;
  const [from, to]: [Corner, Corner] = [[x - margin, y - margin], [x + width + margin, y + height + margin]];
  const isInside = ({ centroid: [u, v] }: Inspection['findings'][number]) => u > from[0] && u < to[0] && v > from[1] && v < to[1];
  expect(before.findings.filter(isInside).length).toBeGreaterThan(0);
  expect(before.findings.filter((finding) => !isInside(finding)).length, 'to be found still').toBeGreaterThan(0);

  await openEditor(page);
  await expect(page.getByTestId('save-regions'), 'nothing was drawn').toBeDisabled();
  await drag(page, from, to);
  await expect(page.getByTestId('left-out-share')).toContainText(/view 1: \d+ % of the picture/);
  await expect(page.getByTestId('compared-already')).toContainText('the comparison must be made again');
  await page.getByTestId('save-regions').click();

  await expect(page.getByTestId('compare')).toBeVisible();
  await page.reload();
  await expect(page.getByTestId('left-out-0')).toContainText(/View 1: 1 region, \d+ % of the picture/);
  const saved = await inspectionOf(page);
  expect(saved.views[0]!.ignore).toHaveLength(1);
  expect(saved).toMatchObject({ stage: 'work', findings: [], compared: [] });

  await page.getByTestId('compare').click();
  await page.getByTestId('reveal').click({ timeout: capture_ms });
  await expect(page.getByTestId('coverage')).toContainText(/% was left out as asked/);
  const after = await inspectionOf(page);
  expect(after.findings.filter(isInside)).toEqual([]);
  expect(after.findings.length).toBeGreaterThan(0);
  const share = ((to[0] - from[0]) * (to[1] - from[1])) / (848 * 480);
  expect(after.compared[0]!.coverage.left_out).toBeCloseTo(share, 2);
});

test('an operator draws by keyboard alone; a viewer sees it and changes nothing', async ({ console: page, served }) => {
  const password = 'correct horse';
  served.account('add', 'olga', ['--role', 'operator'], password);
  served.account('add', 'vera', ['--role', 'viewer'], password);
  const signIn = async (name: string) => {
    await page.getByLabel('Name').fill(name);
    await page.getByLabel('Password').fill(password);
    await page.getByTestId('sign-in').click();
  };
  await page.reload();
  await signIn('olga');
  await begin(page, '');
  await expect(page.getByTestId('page-regions'), 'before there is a baseline').toBeDisabled();
  await page.getByTestId('capture-initial').click();
  await page.getByTestId('open-regions').press('Enter', { timeout: capture_ms });
  await page.getByTestId('add-rectangle').press('Enter');
  await expect(page.getByTestId('region-0')).toBeFocused();
  await expect(page.getByTestId('left-out-share')).toContainText('6 %');
  const first = await cornersOf(page, 0);
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('ArrowUp');
  await expect.poll(() => cornersOf(page, 0)).toEqual(first.map(([u, v]) => [u + 8, v - 8]));
  await page.keyboard.press('Shift+ArrowDown');
  await expect.poll(async () => (await cornersOf(page, 0))[2]).toEqual([first[2]![0] + 8, first[2]![1]]);
  await expect(page.getByTestId('drive-hint'), 'the same keys turn no camera').not.toHaveClass(/warn/);
  for (const viewport of [{ width: 820, height: 1180 }, { width: 1280, height: 800 }]) {
    await page.setViewportSize(viewport);
    await expectTouchable(page);
    await expectAccessible(page);
  }
  await page.getByTestId('add-rectangle').press('Enter');
  await expect(page.getByTestId('region-1')).toBeFocused();
  await page.keyboard.press('Delete');
  await expect(page.getByTestId('region-1')).toHaveCount(0);
  await expect(page.getByTestId('region-0'), 'the next one').toBeFocused();
  await page.getByTestId('save-regions').press('Enter');
  await expect(page.getByTestId('left-out-0')).toContainText('1 region');

  await page.getByRole('button', { name: 'olga · sign out' }).click();
  await signIn('vera');
  await page.getByTestId('open-regions').click();
  await page.getByTestId('region-0').press('Delete');
  await page.getByTestId('region-0').press('ArrowLeft');
  await drag(page, [20, 20], [200, 200]);
  await expect(page.getByTestId('region-1')).toHaveCount(0);
  await expect(page.getByTestId('region-0')).toBeVisible();
  for (const tool of ['add-rectangle', 'save-regions']) await expect(page.getByTestId(tool)).toHaveCount(0);
  const refused = await page.evaluate(async () => {
    const answer = await fetch('/api/inspections/1/regions', {
      method: 'PUT', headers: { 'Content-Type': 'application/json' }, body: JSON.stringify({ view: 0, ignore: [] }),
    });
    return answer.status;
  });
  expect(refused).toBe(403);
  expect((await inspectionOf(page)).views[0]!.ignore).toHaveLength(1);
});

test.describe('on a touch screen', () => {
  test.use({ hasTouch: true, viewport: { width: 820, height: 1180 } });

  test('a region is drawn by its corners, one view after the other', async ({ console: page }) => {
    await begin(page);
    await standIn(page, { stage: 'work', initial: baseline, views: [ahead, { ...ahead, ignore: [[[10, 10], [90, 10], [90, 90]]] }] });
    const sent: { view: number; ignore: Corner[][] }[] = [];
    await page.route('**/regions', async (route) => {
      sent.push(route.request().postDataJSON() as (typeof sent)[number]);
      await route.fulfill({ json: { ...(await inspectionOf(page)) } });
    });
    await openEditor(page);
    const tap = async (corner: Corner) => {
      const { x, y } = await onScreen(page, corner);
      await page.touchscreen.tap(x, y);
    };
    const dots = page.getByTestId('unfinished').locator('.region-corner');
    await page.getByTestId('draw-corners').click();
    await tap([100, 100]);
    await tap([300, 120]);
    await tap([500, 440]);
    await tap([200, 300]);
    await expect(dots).toHaveCount(4);
    await page.getByTestId('undo-corner').click();
    await expect(dots).toHaveCount(3);
    await tap([104, 96]);
    await expect(page.getByTestId('region-0'), 'the first corner closes it').toHaveAttribute('aria-pressed', 'true');
    expect(await cornersOf(page, 0)).toHaveLength(3);

    await page.getByTestId('draw-corners').click();
    await tap([600, 300]);
    await expect(page.getByTestId('close-region')).toBeDisabled();
    await page.getByTestId('cancel-region').click();
    await expect(page.getByTestId('region-1')).toHaveCount(0);

    await page.getByTestId('regions-view-1').click();
    await tap([70, 30]);
    await page.getByTestId('remove-selected').click();
    await expect(page.getByTestId('left-out-share')).toContainText('view 2: nothing');
    await page.getByTestId('page-live').click();
    await expect(page.getByTestId('regions-card')).toContainText('not saved yet');
    await page.getByTestId('open-regions').click();
    await page.getByTestId('save-regions').click();
    await expect.poll(() => sent.map(({ view, ignore }) => [view, ignore.length])).toEqual([[0, 1], [1, 0]]);
    expect(sent[0]!.ignore[0]).toHaveLength(3);
  });
});

test('a region is selected, moved and discarded by mouse, on the depth where there is no colour', async ({ console: page }) => {
  await begin(page);
  const region: Corner[] = [[100, 100], [200, 100], [200, 200], [100, 200]];
  await standIn(page, { stage: 'work', initial: baseline, views: [{ ...ahead, ignore: [region] }] }, false);
  await openEditor(page);
  await expect(page.getByTestId('regions-picture-depth')).toHaveAttribute('aria-checked', 'true');
  await expect(page.getByTestId('regions-picture-color')).toHaveCount(0);
  await drag(page, [150, 150], [250, 190]);
  await expect(page.getByTestId('region-0')).toHaveAttribute('aria-pressed', 'true');
  const corners = await cornersOf(page, 0);
  corners.forEach(([u, v], i) => {
    expect(Math.abs(u - region[i]![0] - 100)).toBeLessThan(2);
    expect(Math.abs(v - region[i]![1] - 40)).toBeLessThan(2);
  });
  await page.getByTestId('discard-regions').click();
  expect(await cornersOf(page, 0)).toEqual(region);
  await expect(page.getByTestId('save-regions')).toBeDisabled();
});

test('the review shows what was probably moved, what was left out and what to mind', async ({ console: page }) => {
  await begin(page);
  const finding = { view: 0, bbox: [100, 100, 40, 30], centroid: [120, 115] } as const;
  await standIn(page, {
    stage: 'review',
    initial: baseline,
    final: baseline,
    comparison: 1,
    compared_at: '2025-01-01T12:00:00Z',
    compared: [{ view: 0, method: 'calibrated', judged: 0.7, warnings: ['the camera turned by 0.98 degrees between the captures'], findable: [],
      coverage: { compared: 0.75, unseen: 0.05, invalid: 0.08, left_out: 0.12 } }],
    findings: [
      { ...finding, number: 4, same_as: 4, kind: 'added', moved_from: 9 },
      { ...finding, number: 9, same_as: 9, kind: 'removed' },
    ] as unknown as Inspection['findings'],
      marked: [],
  });
  await page.getByTestId('reveal').click();
  await expect(page.getByTestId('coverage')).toContainText('12 % was left out as asked');
  const warning = page.getByTestId('view-warning');
  await expect(warning).toContainText('The camera turned by 0.98 degrees');
  await expect(warning).toHaveRole('status');
  await expect(warning).toHaveClass(/bad/);
  const [added, removed] = [page.getByTestId('finding-4'), page.getByTestId('finding-9')];
  await expect(added).toContainText('About the size of finding 2, which was removed: it may have been moved.');
  await expect(removed).toContainText('Finding 1 has about the same size: it may have been moved there.');
  await added.getByRole('button', { name: 'Show finding 2' }).click();
  await expect(removed).toHaveClass(/selected/);
  await removed.getByRole('button', { name: 'Show finding 1' }).click();
  await expect(added).toHaveClass(/selected/);
  await expectTouchable(page);
  await expectAccessible(page);
});
