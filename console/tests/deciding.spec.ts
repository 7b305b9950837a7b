// Deciding on findings: one after the other, back again, by a swipe, and several at once.
import type { Page } from '@playwright/test';
import type { DecisionsRequest, Finding, Inspection } from '../src/types';
import { expectAccessible, expectTouchable } from './accessibility';
import { inspectionOf, standIn } from './region_page';
import { openReview } from './review_page';
import { expect, test } from './served';

/**
 * A review that is decided on as on a server.
 * @param known what the server states of each finding besides
 * @return all requests, the last one last
 */
async function openDecidable(page: Page, known: Partial<Finding> = {}): Promise<DecisionsRequest[]> {
  await openReview(page, true, known);
  let inspection: Inspection = await inspectionOf(page);
  const requests: DecisionsRequest[] = [];
  await page.route('**/api/inspections/1/decisions', (route) => {
    const request = route.request().postDataJSON() as DecisionsRequest;
    requests.push(request);
    const findings = inspection.findings.map(({ decision, ...finding }) => {
      const given = request.decisions.find((one) => one.finding === finding.number);
      if (!given) return { ...finding, ...(decision && { decision }) };
      if (given.verdict === 'undecided') return finding;
      const { verdict, note, object } = given;
      return { ...finding, decision: { verdict, note, ...(object && { object }), person: request.person, decided_at: '2025-01-02T12:00:00Z', round: 1 } };
    });
    inspection = { ...inspection, findings };
    return route.fulfill({ json: inspection });
  });
  await page.getByTestId('reveal').click();
  return requests;
}

/** Moves a finger across the open card. */
async function swipe(page: Page, finding: string, dx_px: number, dy_px: number): Promise<void> {
  const row = page.getByTestId(finding).locator('.row');
  await row.scrollIntoViewIfNeeded();
  const box = (await row.boundingBox())!;
  const [x, y] = [box.x + 0.5 * box.width, box.y + 0.5 * box.height];
  const touch = await page.context().newCDPSession(page);
  const at = (share: number) => [{ x: x + share * dx_px, y: y + share * dy_px }];
  await touch.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: at(0) });
  for (const share of [0.2, 0.4, 0.6, 0.8, 1]) await touch.send('Input.dispatchTouchEvent', { type: 'touchMove', touchPoints: at(share) });
  await touch.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
  await touch.detach();
}

test('a decision is for all views of a finding, leads to the next one, and is taken back', async ({ console: page }) => {
  const requests = await openDecidable(page);
  await expect(page.getByTestId('finding-1')).toHaveClass(/selected/);
  await page.getByLabel('Note').fill('a bolt');
  await page.getByTestId('verdict-debris').click();
  await expect(page.getByTestId('finding-3')).toHaveClass(/selected/);
  expect(requests[0]!.decisions.map(({ finding, verdict, note }) => [finding, verdict, note])).toEqual([[1, 'debris', 'a bolt'], [2, 'debris', 'a bolt']]);
  await page.keyboard.press('5');
  await expect(page.getByTestId('undo-bar')).toContainText('Finding 2: False alarm');
  await expect(page.getByTestId('box-3')).toHaveClass(/settled/);

  // Back to undecided; what was decided before that stays.
  await page.keyboard.press('Control+z');
  await expect(page.getByTestId('finding-3')).toContainText('To be decided');
  await expect(page.getByTestId('finding-1')).toContainText('Debris, still there');
  await expect(page.getByTestId('undo-bar')).toHaveCount(0);

  // A decision that was changed becomes the earlier one again, with its note.
  await page.getByTestId('finding-1').getByRole('button').first().click();
  await page.getByTestId('verdict-debris-removed').click();
  await expect(page.getByTestId('finding-3')).toHaveClass(/selected/);
  await page.getByTestId('undo').click();
  await expect(page.getByTestId('finding-1')).toContainText('Debris, still there');
  await expect(page.getByTestId('finding-1')).toContainText('a bolt');
  await expect(page.getByTestId('finding-1')).toHaveClass(/selected/);
  await page.keyboard.press('n');
  await expect(page.getByTestId('finding-3')).toHaveClass(/selected/);
});

test('a person names what a finding is, and the classifier does not', async ({ console: page }) => {
  const requests = await openDecidable(page, { class: 'wrench', probability: 0.91 });
  await expect(page.getByTestId('finding-1')).toContainText('may be: wrench (91 %)');
  await expect(page.getByTestId('object')).toHaveValue('');
  await expectTouchable(page);
  await page.getByTestId('verdict-debris').click();
  expect(requests[0]!.decisions[0]).not.toHaveProperty('object');
  await expect(page.getByTestId('finding-3')).toHaveClass(/selected/);
  await page.getByTestId('object').selectOption('drill bit');
  await page.getByTestId('verdict-debris-removed').click();
  expect(requests[1]!.decisions.map(({ object }) => object)).toEqual(['drill bit']);
  await page.getByTestId('finding-3').getByRole('button').first().click();
  await expect(page.getByTestId('decision')).toContainText('Debris, removed (drill bit)');
  await expect(page.getByTestId('object')).toHaveValue('drill bit');
});

test('what is pressed as soon as it is there counts', async ({ console: page }) => {
  // Faster than any person: before the browser has painted what it was given.
  await page.addInitScript(() => {
    const press = new MutationObserver(() => {
      const button = document.querySelector<HTMLElement>('[data-testid="reveal"]');
      if (!button) return;
      press.disconnect();
      button.click();
    });
    press.observe(document, { childList: true, subtree: true });
  });
  await openReview(page, false);
  await expect(page.getByTestId('finding-1')).toHaveClass(/selected/);
  await expect(page.getByTestId('first-look')).toHaveCount(0);
});

test('a digit that is pressed as soon as the next finding is shown decides on that one', async ({ console: page }) => {
  const requests = await openDecidable(page);
  await page.evaluate(() => {
    const press = new MutationObserver(() => {
      if (!document.querySelector('[data-testid="finding-3"].selected')) return;
      press.disconnect();
      dispatchEvent(new KeyboardEvent('keydown', { key: '5' }));
    });
    press.observe(document, { attributes: true, childList: true, subtree: true });
  });
  await page.keyboard.press('1');
  await expect(page.locator('.finding.decided')).toHaveCount(2);
  expect(requests.map(({ decisions }) => decisions.map(({ finding, verdict }) => `${finding} ${verdict}`))).toEqual([['1 debris', '2 debris'], ['3 false-alarm']]);
});

test('several findings get one decision in one request', async ({ console: page }) => {
  const requests = await openDecidable(page);
  await page.getByTestId('several').click();
  await expect(page.getByTestId('several-decide')).toBeDisabled();
  await page.getByTestId('finding-3').getByRole('checkbox').click();
  await expect(page.getByTestId('several-form')).toContainText('1 of 2 selected');
  await page.getByTestId('several-undecided').click();
  await expect(page.getByTestId('several-form')).toContainText('2 of 2 selected');
  await page.getByTestId('several-decide').click();
  await expectTouchable(page);
  await expectAccessible(page);
  await page.getByTestId('several-form').getByTestId('verdict-installed-work').click();
  await expect(page.getByTestId('several-form')).toHaveCount(0);
  await expect(page.locator('.finding.decided')).toHaveCount(2);
  expect(requests).toHaveLength(1);
  expect(requests[0]!.decisions.map(({ finding }) => finding)).toEqual([1, 2, 3]);
  await expect(page.getByTestId('undo-bar')).toContainText('Findings 1, 2: Installed work');
  await expectTouchable(page);
  await page.getByTestId('undo').click();
  await expect(page.locator('.finding.decided')).toHaveCount(0);
});

test('closing needs a reason where less than half of a view was inspected', async ({ console: page }) => {
  await openReview(page);
  const { compared } = await inspectionOf(page);
  await standIn(page, { findings: [], compared: compared.map((view) => ({ ...view, judged: 0.4 })), closing_needs_note: true, closing_note_for: ['coverage'] });
  await page.getByTestId('reveal').click();
  await expect(page.getByTestId('all-decided')).toContainText('Less than half of a view was inspected');
  await page.getByTestId('close').click();
  const form = page.getByTestId('close-form');
  await expect(form).toContainText('required: less than half of a view was inspected');
  await expect(form.getByTestId('close-confirm')).toBeDisabled();
  await form.getByLabel('Note').fill('the rest was seen with a mirror');
  await expect(form.getByTestId('close-confirm')).toBeEnabled();
  await expectAccessible(page);
});

test('what the server refuses stays undecided', async ({ console: page }) => {
  await openDecidable(page);
  await page.route('**/api/inspections/1/decisions', (route) => route.fulfill({ status: 409, json: { error: { code: 'refused', message: 'compared again' } } }));
  await page.getByTestId('verdict-false-alarm').click();
  await expect(page.getByTestId('trouble')).toContainText('compared again');
  await expect(page.getByTestId('finding-1')).toHaveClass(/selected/);
  await expect(page.getByTestId('undo-bar')).toHaveCount(0);
});

test.describe('with fingers', () => {
  test.use({ hasTouch: true, viewport: { width: 820, height: 1180 } });

  test('a card is swiped far and sideways to decide, and scrolls otherwise', async ({ console: page }) => {
    const requests = await openDecidable(page);
    await expect(page.getByText('Or swipe the card')).toBeVisible();
    await swipe(page, 'finding-1', 100, 0);
    await swipe(page, 'finding-1', 0, -120);
    await swipe(page, 'finding-1', 300, 300);
    expect(requests).toHaveLength(0);
    await swipe(page, 'finding-1', 380, 10);
    await expect(page.getByTestId('finding-3')).toHaveClass(/selected/);
    await expect(page.getByTestId('finding-1')).toContainText('Debris, still there');
    await swipe(page, 'finding-3', -380, 0);
    await expect(page.getByTestId('undo-bar')).toContainText('Finding 2: False alarm');
    await swipe(page, 'finding-1', -380, 0);
    expect(requests, 'of the card that is open alone').toHaveLength(2);
  });
});
