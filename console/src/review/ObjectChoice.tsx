// What a finding is, as a person names it. It is empty at first, whatever the classifier takes it for: a name that nobody chose would
// confirm the classifier by itself where it is trained with decisions.
import { className } from '../inspection/words';
import { words } from '../words/words';

interface Props {
  chosen: string;
  enabled: boolean;
  onPick: (object: string) => void;
}

export function ObjectChoice({ chosen, enabled, onPick }: Props) {
  const classes = Object.keys(words.finding.classes);
  const named = chosen === '' || classes.includes(chosen) ? classes : [...classes, chosen];
  return (
    <label class="field">
      <span>{words.review.object}</span>
      <select value={chosen} disabled={!enabled} data-testid="object" onChange={(event) => onPick(event.currentTarget.value)}>
        <option value="">{words.review.objectNotNamed}</option>
        {named.map((name) => (
          <option key={name} value={name}>
            {className(name)}
          </option>
        ))}
      </select>
    </label>
  );
}
