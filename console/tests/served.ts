// A server of one test's own, with a simulated bay and robot.
import { test as base, expect, type Browser, type Page } from '@playwright/test';
import { spawn, spawnSync, type ChildProcess } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { createInterface } from 'node:readline';
import { fileURLToPath } from 'node:url';

const root = join(dirname(fileURLToPath(import.meta.url)), '..', '..');
const program = process.env['RVA'] ?? join(root, 'build', 'rva');

export class Served {
  readonly data = mkdtempSync(join(tmpdir(), 'rva-console-'));
  address = '';
  private process: ChildProcess | null = null;

  /** @param port 0 for any @param dither captures of each view @param frames depth images of each view */
  async start(port = 0, more: string[] = [], dither = 2, frames = 16): Promise<void> {
    const scene = join(root, 'data', 'scenes', 'three-tools.yaml');
    const options = ['--camera', `sim:${scene}`, '--robot', 'sim', '--data', this.data, '--port', String(port)];
    this.process = spawn(program, ['serve', ...options, '--frames', String(frames), '--dither', String(dither), ...more], {
      stdio: ['ignore', 'pipe', 'inherit'],
    });
    const lines = createInterface({ input: this.process.stdout! });
    this.address = await new Promise<string>((resolve, reject) => {
      lines.once('line', resolve);
      this.process!.once('exit', (code) => reject(new Error(`rva serve ended with ${code}`)));
    });
  }

  /** `rva account`, as the administrator of the server calls it. */
  account(command: 'add' | 'remove', name: string, more: string[] = [], password = ''): void {
    const done = spawnSync(program, ['account', command, name, '--data', this.data, ...more], { input: `${password}\n` });
    expect(done.status, String(done.stderr)).toBe(0);
  }

  get port(): number {
    return Number(new URL(this.address).port);
  }

  /** As a power cut: at once. */
  async kill(): Promise<void> {
    const gone = new Promise((resolve) => this.process?.once('exit', resolve));
    this.process?.kill('SIGKILL');
    await gone;
  }

  async end(): Promise<void> {
    await this.kill();
    rmSync(this.data, { recursive: true, force: true });
  }
}

export const test = base.extend<{ served: Served; console: Page }>({
  served: async ({}, use) => {
    const served = new Served();
    await served.start();
    await use(served);
    await served.end();
  },
  /** A page whose console stays free of complaints. */
  console: async ({ page, served }, use) => {
    const complaints: string[] = [];
    page.on('pageerror', (error) => complaints.push(error.message));
    page.on('console', (message) => {
      const ofTheNetwork = /ERR_|WebSocket connection|Failed to load resource|GL Driver/.test(message.text());
      if (message.type() === 'error' && !ofTheNetwork) complaints.push(message.text());
    });
    await page.goto(served.address);
    await use(page);
    expect(complaints).toEqual([]);
  },
});

export { expect };

/** From the list to an inspection that has begun. @param name none where it is that of the account */
export async function begin(page: Page, name = 'Ann'): Promise<void> {
  await page.getByLabel('Aircraft').fill('N123AB');
  await page.getByLabel('Aircraft').press('Enter');
  await expect(page.getByLabel('Zone'), 'Enter goes on to what is missing').toBeFocused();
  await page.getByLabel('Zone').fill('Left wing, bay 3');
  await page.getByLabel('Work order').fill('WO-4711');
  if (name) await page.getByLabel('Your name').fill(name);
  await page.getByTestId('begin').click();
  await expect(page.getByTestId('capture-initial')).toBeVisible();
}

/** A page on which a viewer is signed in. */
export async function openAsViewer(browser: Browser, served: Served): Promise<Page> {
  served.account('add', 'expert', ['--role', 'viewer'], 'battery staple');
  const page = await (await browser.newContext()).newPage();
  await page.goto(served.address);
  await page.getByLabel('Name').fill('expert');
  await page.getByLabel('Password').fill('battery staple');
  await page.keyboard.press('Enter');
  return page;
}

export async function angle(page: Page, joint: 'pan' | 'tilt'): Promise<number> {
  return parseFloat((await page.getByTestId(`angle-${joint}`).locator('strong').textContent()) ?? '');
}

/** Two readings apart are the same. */
export async function expectAtRest(page: Page): Promise<void> {
  await expect
    .poll(async () => {
      const before = [await angle(page, 'pan'), await angle(page, 'tilt')];
      await page.waitForTimeout(400);
      return String(before) === String([await angle(page, 'pan'), await angle(page, 'tilt')]);
    })
    .toBe(true);
}
