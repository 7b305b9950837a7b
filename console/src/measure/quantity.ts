// A length with its uncertainty, as people read it.
import { decimal } from '../words/words';

// One digit of the uncertainty that is not 0, and two where the first is 1, since rounding it would change it by half.
function decimalsOf(uncertainty_mm: number): number {
  const exponent = Math.floor(Math.log10(uncertainty_mm));
  const first = Math.round(uncertainty_mm / 10 ** exponent);
  const digits = first === 1 ? exponent - 1 : exponent;
  return Math.min(3, Math.max(0, -digits));
}

/** For example "123.4 mm ± 0.8 mm": the digits follow from the uncertainty. */
export function quantityText(value_mm: number, uncertainty_mm: number): string {
  if (!(uncertainty_mm > 0)) return `${decimal(value_mm, 1)} mm`;
  const decimals = decimalsOf(uncertainty_mm);
  const text = (number: number) => `${decimal(number, decimals).replace('-', '−').replace(/^−(0([.,]0*)?)$/, '$1')} mm`;
  return `${text(value_mm)} ± ${text(uncertainty_mm)}`;
}
