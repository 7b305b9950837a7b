// Changes to the next language.
import { attempt } from '../inspection/inspections';
import { useStore } from '../store';
import { chooseLanguage, language, otherLanguage } from './language';

export function LanguageSwitch() {
  const { code, name } = otherLanguage(useStore(language));
  return (
    <button type="button" class="quiet language-switch" lang={code} aria-label={`${code.toUpperCase()}: ${name}`} data-testid="language" onClick={() => void attempt(() => chooseLanguage(code))}>
      {code.toUpperCase()}
    </button>
  );
}
