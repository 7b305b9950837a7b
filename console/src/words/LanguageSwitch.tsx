// Changes to the next language.
import { useStore } from '../store';
import { pickLanguage } from './LanguageChoice';
import { language, nameOf, otherLanguage } from './language';

export function LanguageSwitch() {
  const code = otherLanguage(useStore(language));
  return (
    <button type="button" class="quiet language-switch" lang={code} aria-label={`${code.toUpperCase()}: ${nameOf(code)}`} data-testid="language" onClick={() => pickLanguage(code)}>
      {code.toUpperCase()}
    </button>
  );
}
