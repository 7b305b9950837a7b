// Where an axis of a stick comes to rest, and how far it is deflected from there.

/** An axis beyond this is held, not at rest. */
export const rest_limit = 0.35;

const still_spread = 0.05;
const still_ms = 500;
// The user may be turning the camera slowly: only an axis that is stiller than any thumb can hold it is at rest.
const still_while_deflected_ms = 2000;

// Before its rest is known, an axis counts only when it is clearly deflected.
const unlearnt_reach = 0.55;
// However worn the stick is, some travel must be left to full deflection.
const longest_dead_way = 0.9;

// A worn stick does not always return to the same position. Later positions replace the earliest, so that one at
// which the stick was held by mistake is forgotten.
const remembered_positions = 8;

interface Position {
  low: number;
  high: number;
  since_ms: number;
}

export class StickRest {
  private readonly positions: Position[] = [];
  private latest: Position = { low: NaN, high: NaN, since_ms: NaN };

  /** Learns from the position of the axis at a time. */
  observe(raw: number, now_ms: number, dead_zone: number): void {
    const low = Math.min(raw, this.latest.low);
    const high = Math.max(raw, this.latest.high);
    if (high - low <= still_spread) Object.assign(this.latest, { low, high });
    else this.latest = { low: raw, high: raw, since_ms: now_ms };

    const needed_ms = this.deflection(raw, dead_zone) === 0 ? still_ms : still_while_deflected_ms;
    const isStill = now_ms - this.latest.since_ms >= needed_ms;
    if (!isStill || !canRestAt(raw, dead_zone) || this.positions.includes(this.latest)) return;
    this.positions.push(this.latest);
    if (this.positions.length > remembered_positions) this.positions.shift();
  }

  /** Whether the axis is in a position in which it cannot be when the stick is let go. */
  isAstray(raw: number, dead_zone: number): boolean {
    if (!Number.isFinite(raw) || this.deflection(raw, dead_zone) !== 0) return true;
    return this.positions.length === 0 && !canRestAt(raw, dead_zone);
  }

  /** 0 at rest and within the dead zone around it, -1 and 1 at the ends; quadratic, for fine control near the middle. */
  deflection(raw: number, dead_zone: number): number {
    if (!Number.isFinite(raw)) return 0;
    const { low, high } = this.range();
    const from = Math.min(longest_dead_way, high + dead_zone);
    const to = Math.max(-longest_dead_way, low - dead_zone);
    if (raw >= to && raw <= from) return 0;
    const beyond = raw > from ? (raw - from) / (1 - from) : (raw - to) / (1 + to);
    const within = Math.max(-1, Math.min(1, beyond));
    return within * Math.abs(within);
  }

  // The range always contains the middle, so that letting go stops the camera even if a position was learnt while
  // the stick was held.
  private range(): { low: number; high: number } {
    if (this.positions.length === 0) return { low: -unlearnt_reach, high: unlearnt_reach };
    return {
      low: Math.min(0, ...this.positions.map((position) => position.low)),
      high: Math.max(0, ...this.positions.map((position) => position.high)),
    };
  }
}

function canRestAt(raw: number, dead_zone: number): boolean {
  return Math.abs(raw) < Math.max(rest_limit, dead_zone);
}
