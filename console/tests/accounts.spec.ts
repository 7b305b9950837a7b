// Where there are accounts, everybody signs in.
import type { Page } from '@playwright/test';
import { expectAccessible, expectTouchable } from './accessibility';
import { begin, expect, test } from './served';

const password = 'correct horse';

async function signIn(page: Page, name: string, entered = password): Promise<void> {
  await page.getByLabel('Name').fill(name);
  await page.getByLabel('Password').fill(entered);
  await page.getByTestId('sign-in').click();
}

test('a viewer signs in, views and signs out', async ({ console: page, served }) => {
  served.account('add', 'vera', ['--role', 'viewer'], password);
  await page.reload();
  await expectAccessible(page);
  await expectTouchable(page);
  await signIn(page, 'vera', 'wrong horse');
  await expect(page.getByRole('alert')).toContainText('name or password is wrong');
  await expect(page.getByLabel('Password'), 'to be typed anew').toHaveValue('');
  await signIn(page, 'vera');
  await expect(page.getByTestId('camera-chip')).toContainText('✓ Camera');
  await expect(page.getByTestId('take')).toBeDisabled();
  await page.getByLabel('Aircraft').fill('N123AB');
  await page.getByLabel('Zone').fill('Left wing, bay 3');
  await expect(page.getByTestId('begin')).toBeDisabled();
  await expect(page.getByTestId('stop'), 'a stop is everybody\'s').toBeEnabled();
  await page.reload();
  await expect(page.getByTestId('camera-chip'), 'signed in until they sign out').toContainText('✓ Camera');
  await page.getByRole('button', { name: 'vera · sign out' }).click();
  await expect(page.getByTestId('sign-in')).toBeVisible();
});

test('an operator works under the name of the account, and is out when it goes', async ({ console: page, served }) => {
  served.account('add', 'olga', ['--role', 'operator'], password);
  served.account('add', 'ines', ['--role', 'inspector'], password);
  await page.reload();
  await signIn(page, 'olga');
  await begin(page, '');
  await page.getByTestId('take').click();
  await expect(page.getByTestId('release')).toBeVisible();
  served.account('remove', 'olga');
  await expect(page.getByRole('alert')).toContainText('no longer');
  await page.getByRole('button', { name: 'Reload the page' }).click();
  await expect(page.getByTestId('sign-in')).toBeVisible();
  await signIn(page, 'ines');
  await page.getByTestId('home').click();
  await expect(page.getByTestId('open-1')).toContainText('olga');
});

test('the console asks to sign in again after a restart of the server', async ({ console: page, served }) => {
  served.account('add', 'olga', ['--role', 'operator'], password);
  await page.reload();
  await signIn(page, 'olga');
  await expect(page.getByTestId('camera-chip')).toContainText('✓ Camera');
  const port = served.port;
  await served.kill();
  await expect(page.getByTestId('camera-chip')).toContainText('No connection');
  await served.start(port);
  await expect(page.getByRole('alert')).toContainText('no longer signed in');
});
