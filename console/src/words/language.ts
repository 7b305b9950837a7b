// The language of the console: that of the browser until the user chooses another one.
import { Refusal } from '../link/refusal';
import { Store } from '../store';
import { en, type Words } from './en';
import { setWords, words } from './words';

/** Another language is one more file, loaded when it is needed, and one more line here. */
const loaders = {
  en: { name: 'English', load: () => Promise.resolve(en) },
  de: { name: 'Deutsch', load: () => import('./de').then((loaded) => loaded.de) },
} satisfies Record<string, { name: string; load: () => Promise<Words> }>;

export type Language = keyof typeof loaders;
export const languages = Object.keys(loaders) as Language[];

const key = 'rva-language';

/** The language that is shown. */
export const language = new Store<Language>('en');

function isLanguage(code: string | null | undefined): code is Language {
  return code !== null && code !== undefined && Object.hasOwn(loaders, code);
}

function chosen(): Language | null {
  try {
    const code = localStorage.getItem(key);
    return isLanguage(code) ? code : null;
  } catch {
    return null;
  }
}

function codeOf(tag: string): string {
  return tag.slice(0, 2).toLowerCase();
}

function ofBrowser(): Language {
  return navigator.languages.map(codeOf).find(isLanguage) ?? 'en';
}

async function show(next: Language): Promise<void> {
  const loaded = await loaders[next].load();
  setWords(loaded, navigator.languages.find((tag) => codeOf(tag) === next) ?? next);
  document.documentElement.lang = next;
  language.value = next;
}

/** Shows the chosen language, or that of the browser; English where it cannot be loaded. Called once. */
export async function beginLanguage(): Promise<void> {
  await show(chosen() ?? ofBrowser()).catch(() => show('en'));
}

/** The name of a language in itself. */
export function nameOf(code: Language): string {
  return loaders[code].name;
}

/** The language after the one that is shown. */
export function otherLanguage(now: Language): Language {
  return languages[(languages.indexOf(now) + 1) % languages.length] ?? 'en';
}

function keep(code: Language | null): void {
  try {
    if (code === null) localStorage.removeItem(key);
    else localStorage.setItem(key, code);
  } catch (error) {
    console.warn(`${key} is not kept beyond this page: ${String(error)}`);
  }
}

/**
 * The choice is kept at once, also for a page that is left before the texts have arrived. A browser that stores nothing keeps
 * it until the page is closed.
 * @throws Refusal when the texts cannot be loaded; the choice of before is then kept
 */
export async function chooseLanguage(next: Language): Promise<void> {
  const before = chosen();
  keep(next);
  await show(next).catch(() => {
    keep(before);
    throw new Refusal('console', words.page.noServer);
  });
}
