// A choice of one among a few options, all of them visible.
interface Props<T extends string> {
  label: string;
  options: [T, string][];
  value: T;
  /** Prefix of the options' test ids. */
  name?: string;
  /** Whether no other option can be chosen at the moment. */
  disabled?: boolean;
  onPick: (value: T) => void;
}

export function Choice<T extends string>({ label, options, value, name = label.toLowerCase(), disabled = false, onPick }: Props<T>) {
  return (
    <div class="switch" role="radiogroup" aria-label={label}>
      {options.map(([option, text]) => (
        <button key={option} type="button" role="radio" aria-checked={option === value} disabled={disabled} data-testid={`${name}-${option}`} onClick={() => onPick(option)}>
          {text}
        </button>
      ))}
    </div>
  );
}
