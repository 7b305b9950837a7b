// A request or a message that was refused.
import type { ErrorCode } from '../types';

/** 'console': refused by the console itself, in the language that it shows; 'unknown': for a reason that has no code. */
export type RefusalCode = ErrorCode | 'console' | 'unknown';

/** The message is the server's, which is English, or the console's own. */
export class Refusal extends Error {
  constructor(
    readonly code: RefusalCode,
    message: string,
    /** The HTTP status; 0 where there is none. */
    readonly status = 0,
  ) {
    super(message);
  }
}

export function refusalOf(error: unknown): Refusal {
  return error instanceof Refusal ? error : new Refusal('unknown', error instanceof Error ? error.message : String(error));
}
