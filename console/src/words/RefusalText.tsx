// Why something was refused, in the language that is shown; the server's sentence, which is English, as detail.
import './refusal.css';
import type { Refusal, RefusalCode } from '../link/refusal';
import { words } from './words';

/** What these codes mean is all there is to state. */
const complete: RefusalCode[] = ['wrong-password', 'sign-in-required'];

export function RefusalText({ refusal: { code, message } }: { refusal: Refusal }) {
  if (code === 'console') return <span>{message}</span>;
  const known = Object.hasOwn(words.refusals, code) ? code : 'unknown';
  return (
    <span class="refusal">
      {words.refusals[known]}
      {!complete.includes(code) && <small lang="en">{message}</small>}
    </span>
  );
}
