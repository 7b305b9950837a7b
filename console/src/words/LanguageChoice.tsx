// All languages, each named in itself: on the page of the sign-in, nothing else shows where to change it.
import { trouble } from '../inspection/inspections';
import { refusalOf } from '../link/refusal';
import { useStore } from '../store';
import { chooseLanguage, language, languages, nameOf, type Language } from './language';
import { words } from './words';

/** Shows a language. What was refused before stays visible, in that language. */
export function pickLanguage(code: Language): void {
  chooseLanguage(code).catch((error: unknown) => (trouble.value = refusalOf(error)));
}

export function LanguageChoice() {
  const shown = useStore(language);
  return (
    <div class="switch" role="radiogroup" aria-label={words.page.language}>
      {languages.map((code) => (
        <button key={code} type="button" role="radio" aria-checked={code === shown} lang={code} data-testid={`language-${code}`} onClick={() => pickLanguage(code)}>
          {nameOf(code)}
        </button>
      ))}
    </div>
  );
}
