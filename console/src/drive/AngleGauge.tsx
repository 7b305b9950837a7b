// The angle of a joint, shown between its soft limits.
import { decimal } from '../words/words';

interface Props {
  joint: 'pan' | 'tilt';
  label: string;
  angle_deg: number | undefined;
  limits_deg: [number, number];
  /** Pan is positive to the left, so its scale runs from right to left. */
  reversed?: boolean;
}

export function AngleGauge({ joint, label, angle_deg, limits_deg, reversed }: Props) {
  const [low, high] = limits_deg;
  const share = angle_deg === undefined ? 0.5 : (angle_deg - low) / (high - low);
  const left = 100 * Math.max(0, Math.min(1, reversed ? 1 - share : share));
  const text = angle_deg === undefined ? '–' : `${decimal(angle_deg, 1)}°`;
  return (
    <div class="gauge" data-testid={`angle-${joint}`}>
      <div class="gauge-head">
        <span>{label}</span>
        <strong>{text}</strong>
      </div>
      <div class="gauge-bar" aria-hidden="true">
        {angle_deg !== undefined && <span class="gauge-mark" style={{ left: `${left}%` }} />}
      </div>
      <div class="gauge-ends">
        <span>{reversed ? high : low}°</span>
        <span>{reversed ? low : high}°</span>
      </div>
    </div>
  );
}
