// Running other programs. Only node's own modules: set-up runs before anything is installed.
import { spawn, spawnSync } from 'node:child_process';

/** A failure a person can mend: its message is printed without a stack. */
export class SetupError extends Error {}

/** Runs a program with its output shown, and throws when it fails. */
export function run(program, args, options = {}) {
  const result = spawnSync(program, args, { stdio: ['ignore', 'inherit', 'inherit'], ...options });
  if (result.error) throw new SetupError(`${program}: ${result.error.message}`);
  expectSuccess(program, args, result.status, result.signal);
}

function expectSuccess(program, args, status, signal) {
  if (status === 0) return;
  const ending = signal ? `signal ${signal}` : `status ${status}`;
  throw new SetupError(`${program} ${args[0] ?? ''} ended with ${ending}`);
}

/**
 * Runs a program once for each of `options`, all at the same time, and shows what each printed when it has ended.
 * Throws when one has failed, once all have ended.
 */
export async function runTogether(program, args, options) {
  const endings = options.map(
    (own) =>
      new Promise((resolve, reject) => {
        const child = spawn(program, args, { stdio: ['ignore', 'pipe', 'pipe'], ...own });
        const printed = [];
        for (const stream of [child.stdout, child.stderr]) {
          stream.on('data', (chunk) => printed.push(chunk));
        }
        child.on('error', ({ message }) => reject(new SetupError(`${program}: ${message}`)));
        child.on('close', (status, signal) => {
          process.stdout.write(Buffer.concat(printed));
          resolve([status, signal]);
        });
      }),
  );
  for (const [status, signal] of await Promise.all(endings)) {
    expectSuccess(program, args, status, signal);
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
export async function main(body) {
  try {
    await body();
  } catch (error) {
    if (!(error instanceof SetupError)) throw error;
    console.error(error.message);
    process.exit(1);
  }
}
