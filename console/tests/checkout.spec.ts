// The check-out list: what goes into the bay, and what becomes of it.
import { expectAccessible, expectTouchable } from './accessibility';
import { begin, expect, openAsViewer, test } from './served';

test('tools and parts are listed, and accounted for', async ({ console: page }) => {
  await begin(page);
  const card = page.getByTestId('checkout');
  await expect(card).toContainText('Nothing listed');
  await card.locator('summary').click();
  await card.getByLabel('Tool or part').fill('wrench, "small"');
  await card.getByLabel('Number').fill('T-12');
  await card.getByTestId('add-item-confirm').click();
  await expect(page.getByTestId('item-1')).toContainText('wrench, "small" T-12');
  await expect(card.getByLabel('Tool or part'), 'for the next one').toHaveValue('');

  const csv = (text: string) => ({ name: 'crib.csv', mimeType: 'text/csv', buffer: Buffer.from(text) });
  await page.getByTestId('items-file').setInputFiles(csv('Item;Quantity\r\ncollar;24\r\nrag;2\r\n'));
  await expect(page.getByTestId('item-2')).toContainText('collar × 24');
  await page.getByTestId('items-file').setInputFiles(csv('price\n7\n'));
  await expect(page.getByRole('alert')).toContainText('unknown column');
  await expect(card).toContainText('0 of 3 accounted for');

  await page.getByTestId('item-back-1').click();
  await expect(page.getByTestId('item-1')).toContainText('accounted for');
  await page.getByRole('button', { name: 'What became of collar' }).click();
  const form = page.getByTestId('item-form-2');
  await form.getByLabel('Used or installed').fill('23');
  await form.getByLabel('Lost', { exact: true }).fill('2');
  await expect(page.getByTestId('item-state'), 'more than there are').toBeDisabled();
  await form.getByLabel('Lost', { exact: true }).fill('1');
  await expectAccessible(page);
  await expectTouchable(page);
  await page.getByTestId('item-state').click();
  await expect(page.getByTestId('item-2')).toContainText('lost (0 returned, 23 used, 1 lost)');
  await expect(card).toContainText('1 of 3 accounted for');

  await page.getByRole('button', { name: 'What became of collar' }).click();
  await form.getByLabel('I take the responsibility').check();
  await expect(page.getByTestId('item-state'), 'not without a note').toBeDisabled();
  await form.getByLabel('Note').fill('seen to fall outside');
  await page.getByTestId('item-state').click();
  await expect(page.getByTestId('item-2')).toContainText('lost, released (0 returned, 23 used, 1 lost): seen to fall outside');
  await page.getByTestId('item-back-3').click();
  await expect(card).toContainText('3 of 3 accounted for');
  await page.reload();
  await expect(page.getByTestId('checkout')).toContainText('3 of 3 accounted for');
});

test('a viewer sees the list, and changes nothing', async ({ browser, console: page, served }) => {
  await begin(page);
  const card = page.getByTestId('checkout');
  await card.locator('summary').click();
  await card.getByLabel('Tool or part').fill('wrench');
  await card.getByTestId('add-item-confirm').click();
  await expect(page.getByTestId('item-1')).toBeVisible();
  const other = await openAsViewer(browser, served);
  await other.goto(`${served.address}/#/inspections/1`);
  await other.getByTestId('checkout').locator('summary').click();
  await expect(other.getByTestId('item-1')).toContainText('in the bay');
  await expect(other.getByTestId('item-back-1')).toHaveCount(0);
  await expect(other.getByTestId('add-item')).toHaveCount(0);
});
