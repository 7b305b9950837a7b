// Components on a page of their own, without a server.
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { Page } from '@playwright/test';
import { build } from 'vite';

const sources = join(dirname(fileURLToPath(import.meta.url)), '..', 'src');

/** @param source TypeScript that renders into the element `#here`; it imports from `/src/` as from console/src */
export async function mount(page: Page, source: string): Promise<void> {
  const entry = join(sources, 'mounted.tsx');
  const made = await build({
    configFile: false,
    logLevel: 'silent',
    esbuild: { jsx: 'automatic', jsxImportSource: 'preact' },
    plugins: [
      {
        name: 'mounted',
        enforce: 'pre',
        resolveId: (id) => (id === entry ? entry : undefined),
        load: (id) => (id === entry ? source.replaceAll("'/src/", "'./") : undefined),
      },
    ],
    build: { write: false, target: 'es2022', rollupOptions: { input: entry } },
  });
  const files = 'output' in made ? made.output : [];
  const textOf = (end: string) => files.filter((file) => file.fileName.endsWith(end)).map((file) => (file.type === 'chunk' ? file.code : String(file.source))).join('\n');
  await page.setContent('<!doctype html><html lang="en"><title>RVA</title><main id="here" style="height: 100vh"></main>');
  await page.addStyleTag({ content: textOf('.css') });
  await page.addScriptTag({ content: textOf('.js'), type: 'module' });
}
