// The settings and taught mappings of controllers, stored by the browser for this computer.
import { Store } from '../store';
import { isTaughtMapping, type TaughtMapping, type TaughtMappings } from './pad_mapping';

export const dead_zone_range = { least: 0.05, usual: 0.15, most: 0.5 };

const dead_zone_key = 'rva-dead-zone';
const mappings_key = 'rva-controllers';

function stored(key: string): unknown {
  try {
    return JSON.parse(localStorage.getItem(key) ?? 'null');
  } catch {
    return null;
  }
}

// A browser that stores nothing, as in some private windows, keeps the value until the page is closed.
function store(key: string, value: unknown): void {
  try {
    localStorage.setItem(key, JSON.stringify(value));
  } catch (error) {
    console.warn(`${key} is not kept beyond this page: ${String(error)}`);
  }
}

function storedDeadZone(): number {
  const value = stored(dead_zone_key);
  const { least, usual, most } = dead_zone_range;
  return typeof value === 'number' && value >= least && value <= most ? value : usual;
}

function storedMappings(): TaughtMappings {
  const values = Object.entries(Object(stored(mappings_key)) as Record<string, unknown>);
  return Object.fromEntries(values.filter((entry): entry is [string, TaughtMapping] => isTaughtMapping(entry[1])));
}

class PadMemory {
  readonly deadZone = new Store(storedDeadZone());
  /** By the id of the controller. */
  readonly taught = new Store(storedMappings());

  constructor() {
    this.deadZone.subscribe(() => store(dead_zone_key, this.deadZone.value));
    this.taught.subscribe(() => store(mappings_key, this.taught.value));
  }

  teach(id: string, mapping: TaughtMapping): void {
    this.taught.value = { ...this.taught.value, [id]: mapping };
  }

  forget(id: string): void {
    this.taught.value = Object.fromEntries(Object.entries(this.taught.value).filter(([other]) => other !== id));
  }
}

export const padMemory = new PadMemory();
