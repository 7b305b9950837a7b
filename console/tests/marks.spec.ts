// What a person sees and the program does not: marked in the live picture and in the review.
import type { Page } from '@playwright/test';
import { begin, expect, test } from './served';

async function drag(page: Page, testId: string): Promise<void> {
  const box = (await page.getByTestId(testId).boundingBox())!;
  await page.mouse.move(box.x + 0.4 * box.width, box.y + 0.5 * box.height);
  await page.mouse.down();
  await page.mouse.move(box.x + 0.5 * box.width, box.y + 0.6 * box.height, { steps: 3 });
  await page.mouse.up();
}

test('findings are marked by hand, stay through the rounds, and are decided like any other', async ({ console: page }) => {
  await begin(page);
  await page.getByTestId('capture-initial').click();
  await expect(page.getByTestId('work')).toBeVisible({ timeout: 60_000 });

  // In the live picture, during the work.
  await page.getByRole('button', { name: 'Mark a finding' }).click();
  await drag(page, 'live');
  await page.getByLabel('What did you mark?').fill('a rag on the spar');
  await page.getByTestId('mark-save').click();
  await expect(page.getByTestId('mark-form')).toHaveCount(0);

  // Nothing was changed, so the program finds nothing; what was marked is a finding all the same.
  await page.getByTestId('capture-final').click();
  await expect(page.getByTestId('first-look')).toBeVisible({ timeout: 90_000 });
  await page.getByTestId('reveal').click();
  await expect(page.getByTestId('finding--1')).toContainText('a rag on the spar');
  await page.getByRole('button', { name: 'Mark a finding' }).click();
  await drag(page, 'picture-after');
  await page.getByLabel('What did you mark?').fill('a washer');
  await page.getByTestId('mark-save').click();
  await expect(page.getByTestId('finding--2')).toContainText('a washer');
  await expect(page.getByTestId('finding--2')).toContainText('m away');
  await expect(page.getByTestId('box--2')).toBeVisible();
  await expect(page.getByTestId('close')).toBeDisabled();

  // Debris, and then its removal.
  await page.getByTestId('finding--2').getByTestId('verdict-debris').click();
  await expect(page.getByTestId('all-decided')).toContainText('1 to be removed');
  await expect(page.getByTestId('finding--1')).toHaveClass(/selected/);
  await page.getByTestId('finding--2').getByRole('button').first().click();
  await page.getByTestId('finding--2').getByTestId('verdict-debris-removed').click();
  // By keyboard, on the finding that is selected next.
  await expect(page.getByTestId('finding--1')).toHaveClass(/selected/);
  await page.keyboard.press('5');
  await expect(page.getByTestId('finding--1')).toContainText('False alarm');
  await page.getByTestId('capture-again').click();
  await expect(page.getByTestId('progress')).toBeVisible();
  await expect(page.getByTestId('first-look')).toBeVisible({ timeout: 90_000 });
  await page.getByTestId('reveal').click();
  await expect(page.getByTestId('finding--2')).toContainText('Debris, removed');

  // Its address leads there again, and *Back* to what was shown before.
  await page.getByTestId('finding--2').getByRole('button').first().click();
  await expect.poll(() => page.url()).toContain('#/inspections/1/review/-2');
  await page.getByTestId('page-space').click();
  await expect.poll(() => page.url()).toContain('#/inspections/1/space');
  await page.goBack();
  await expect(page.getByTestId('picture-after')).toBeVisible();
  await page.reload();
  await expect(page.getByTestId('finding--2')).toHaveClass(/selected/);
});

test('inspections are found by what they are about, and empty ones are deleted', async ({ console: page }) => {
  for (const zone of ['Left wing', 'Tail']) {
    await page.getByLabel('Aircraft').fill('N1');
    await page.getByLabel('Zone').fill(zone);
    await page.getByLabel('Your name').fill('Ann');
    await page.getByTestId('begin').click();
    await expect(page.getByTestId('capture-initial')).toBeVisible();
    await page.getByTestId('home').click();
    await expect(page.getByTestId('search')).toBeVisible();
  }
  await expect(page.getByTestId('open-1')).toBeVisible();
  await page.getByTestId('search').fill('n1 tail');
  await expect(page.getByTestId('open-1')).toHaveCount(0);
  await expect(page.getByTestId('open-2')).toBeVisible();
  await page.getByTestId('delete-2').click();
  await expect(page.getByText('No inspection matches.')).toBeVisible();
  await page.getByTestId('search').fill('');
  await expect(page.getByTestId('open-1')).toBeVisible();
  await page.getByText('By step and date').click();
  await page.getByTestId('search-stage').selectOption('done');
  await expect(page.getByText('No inspection matches.')).toBeVisible();
});

test('an inspection that was left is not shown again by what arrives later', async ({ console: page }) => {
  await begin(page);
  let answer = (): void => undefined;
  const asked = new Promise<void>((resolve) => {
    const held = new Promise<void>((release) => (answer = release));
    void page.route('**/api/inspections/1', async (route) => {
      resolve();
      await held;
      await route.continue();
    });
  });
  await page.getByRole('button', { name: 'Check again' }).click();
  await asked;
  await page.getByTestId('home').click();
  await expect(page.getByTestId('search')).toBeVisible();
  const answered = page.waitForResponse('**/api/inspections/1');
  answer();
  await (await answered).finished();
  await page.evaluate(() => new Promise((painted) => requestAnimationFrame(() => requestAnimationFrame(painted))));
  await expect(page.getByTestId('search')).toBeVisible();
});
