// Closing an inspection and signing it, with the passwords of the people at the console.
import { expectAccessible, expectTouchable } from './accessibility';
import { begin, expect, test } from './served';

test('an inspector closes and signs, and a mechanic signs, too', async ({ console: page, served }) => {
  served.account('add', 'ida', ['--role', 'inspector'], 'correct horse');
  served.account('add', 'max', ['--role', 'operator'], 'battery staple');
  await page.reload();
  await page.getByLabel('Name').fill('ida');
  await page.getByLabel('Password').fill('correct horse');
  await page.getByTestId('sign-in').click();
  await begin(page, '');

  // Nothing changes in the bay; a finding, should there be one, is a false alarm.
  const address = `${served.address}/api/inspections/1`;
  const inspection = async () => (await page.request.get(address)).json() as Promise<{ initial?: object; compared_at?: string; comparison: number; findings: { number: number }[] }>;
  const post = (what: string, data: object) => page.request.post(`${address}/${what}`, { data });
  await post('capture', { side: 'initial', person: 'ida', replaced: false });
  await expect.poll(async () => (await inspection()).initial, { timeout: 60_000 }).toBeDefined();
  await post('capture', { side: 'final', person: 'ida', replaced: false });
  await expect.poll(async () => (await inspection()).compared_at, { timeout: 60_000 }).toBeDefined();
  const { comparison, findings } = await inspection();
  for (const { number } of findings) await post(`findings/${number}/decision`, { comparison, verdict: 'false-alarm', note: '', person: 'ida' });

  await page.goto(`${served.address}/#/inspections/1/review`);
  await page.reload();
  await page.getByTestId('reveal').click();
  await expect(page.getByTestId('close')).toHaveText('Close and sign');
  await page.getByTestId('close').click();
  const closing = page.getByTestId('close-form');
  await expect(page.getByTestId('close-confirm'), 'not without a password').toBeDisabled();
  await page.getByTestId('add-signer').click();
  await page.getByTestId('add-signer').click();
  await expect(page.getByTestId('close-confirm'), 'however many sign').toBeInViewport({ ratio: 1 });
  await page.getByRole('button', { name: 'Not yet' }).click();
  await page.getByTestId('close').click();
  await closing.getByLabel('Password of ida').fill('wrong horse');
  await page.getByTestId('close-confirm').click();
  await expect(page.getByRole('alert')).toContainText('name or password is wrong');

  // It is closed, and still to be signed.
  await expect(page.getByTestId('closed')).toContainText('Not signed yet');
  await page.getByTestId('sign').click();
  const signing = page.getByTestId('sign-form');
  await signing.getByLabel('Password of ida').fill('correct horse');
  await page.getByTestId('add-signer').click();
  await expect(page.getByTestId('sign-confirm'), 'not without the other one').toBeDisabled();
  await signing.getByLabel('Name').fill('max');
  await signing.getByLabel('Password', { exact: true }).fill('battery staple');
  await expect(page.getByTestId('sign-confirm')).toBeInViewport({ ratio: 1 });
  await expectAccessible(page);
  await expectTouchable(page);
  await page.getByTestId('sign-confirm').click();
  await expect(page.getByTestId('signed')).toContainText('Signed by ida, max');
  await expect(page.getByTestId('signed')).toContainText('signed/000001-1');
  await page.getByTestId('home').click();
  await expect(page.getByTestId('open-1')).toContainText('Closed, signed');
});
