// Running other programs. Only node's own modules: set-up runs before anything is installed.
import { spawnSync } from 'node:child_process';

/** A failure a person can mend: its message is printed without a stack. */
export class SetupError extends Error {}

/** Runs a program with its output shown, and throws when it fails. */
export function run(program, args, options = {}) {
  const result = spawnSync(program, args, { stdio: ['ignore', 'inherit', 'inherit'], ...options });
  if (result.error) throw new SetupError(`${program}: ${result.error.message}`);
  if (result.status !== 0) {
    const ending = result.signal ? `signal ${result.signal}` : `status ${result.status}`;
    throw new SetupError(`${program} ${args[0] ?? ''} ended with ${ending}`);
  }
}

/** Runs a program and returns what it printed, or null when it fails or is missing. */
export function capture(program, args, options = {}) {
  const result = spawnSync(program, args, {
    encoding: 'utf8',
    stdio: ['ignore', 'pipe', 'ignore'],
    maxBuffer: 1 << 26,
    ...options,
  });
  return result.status === 0 ? result.stdout : null;
}

/** Runs a script's body; an expected failure becomes one line and status 1. */
export function main(body) {
  try {
    body();
  } catch (error) {
    if (!(error instanceof SetupError)) throw error;
    console.error(error.message);
    process.exit(1);
  }
}
