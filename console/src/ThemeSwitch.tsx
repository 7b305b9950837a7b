// Changes between the dark and the bright theme.
import { useStore } from './store';
import { chooseTheme, theme } from './theme';
import { words } from './words/words';

export function ThemeSwitch() {
  const bright = useStore(theme) === 'bright';
  return (
    <button type="button" class="quiet theme-switch" role="switch" aria-checked={bright} aria-label={words.page.sunlight} data-testid="theme" onClick={() => chooseTheme(bright ? 'dark' : 'bright')}>
      <span aria-hidden="true">{bright ? '◑' : '◐'}</span>
    </button>
  );
}
