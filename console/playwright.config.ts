import { defineConfig } from '@playwright/test';

export default defineConfig({
  testDir: 'tests',
  // Pure code does not need a browser or a server.
  projects: [
    { name: 'unit', testMatch: 'unit/*.spec.ts' },
    { name: 'browser', testMatch: '*.spec.ts', testIgnore: ['unit/**', 'pictures/**'] },
    // Not a test: it performs an inspection to take the pictures of docs/console.md.
    { name: 'pictures', testMatch: 'pictures/*.spec.ts' },
  ],
  workers: 1,
  timeout: 120_000,
  expect: { timeout: 20_000 },
  reporter: [['list']],
  outputDir: process.env['RVA_BROWSER_OUT'] ?? '../build/browser',
  use: {
    viewport: { width: 1280, height: 800 },
    trace: 'off',
    launchOptions: {
      executablePath: process.env['RVA_CHROMIUM'] ?? '/usr/bin/chromium',
      // As root, as in a container, Chromium has no sandbox; without a GPU it draws 3D by itself.
      args: ['--no-sandbox', '--enable-unsafe-swiftshader'],
    },
  },
});
