// The theme: dark, or bright for sunlight. Until the user chooses one, it is that of the system.
import { Store } from './store';

export type Theme = 'dark' | 'bright';

const key = 'rva-theme';
const system = window.matchMedia('(prefers-color-scheme: light)');

function chosen(): Theme | null {
  try {
    const value = localStorage.getItem(key);
    return value === 'dark' || value === 'bright' ? value : null;
  } catch {
    return null;
  }
}

function ofSystem(): Theme {
  return system.matches ? 'bright' : 'dark';
}

export const theme = new Store<Theme>(chosen() ?? ofSystem());

/** The value of a colour of `theme.css`, for what is not drawn by CSS. */
export function colorOf(name: `--${string}`): string {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}

function apply(): void {
  document.documentElement.dataset['theme'] = theme.value;
  document.querySelector('meta[name="theme-color"]')?.setAttribute('content', colorOf('--panel'));
}

/** Shows the theme from now on; called once. */
export function followTheme(): void {
  apply();
  theme.subscribe(apply);
  system.addEventListener('change', () => {
    if (!chosen()) theme.value = ofSystem();
  });
}

/** A browser that stores nothing, as in some private windows, keeps the choice until the page is closed. */
export function chooseTheme(next: Theme): void {
  theme.value = next;
  try {
    localStorage.setItem(key, next);
  } catch (error) {
    console.warn(`${key} is not kept beyond this page: ${String(error)}`);
  }
}
