/** Runs the built command line and looks at what it leaves behind. */
import { spawn } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const script = fileURLToPath(new URL('../../dist/cli/foldwright.js', import.meta.url));

/** Where tests must not vanish: what they need is there, or they fail. */
function required<Found>(found: Found | null, what: string): Found | null {
  if (found === null && process.env['CI']) throw new Error(`CI is set, but ${what} is missing`);
  return found;
}

/** `npm test` builds it first; a bare run of the tests may not have it. */
export const isBuilt = required(existsSync(script) || null, 'the built command') !== null;

/** Ms after which a run counts as one that hangs. Generous: some models are large, and machines differ. */
export const runLimit = 240_000;

export interface Ended {
  /** Exit status, or null if a signal or the time limit ended it. */
  status: number | null;
  stdout: string;
  stderr: string;
}

export interface CommandOptions {
  /** Milliseconds after which the program is killed; default `runLimit`. */
  limit?: number;
  /** Sent as soon as the program says anything on stderr, or what `after` waits for. */
  interrupt?: NodeJS.Signals;
  /** What has to stand on stdout before it is interrupted. */
  after?: string;
}

/** Runs `foldwright` with these arguments to its end. */
export function foldwright(args: string[], options: CommandOptions = {}): Promise<Ended> {
  const { after, interrupt, limit = runLimit } = options;
  return new Promise((resolve, reject) => {
    const child = spawn(process.execPath, [script, ...args], { stdio: ['ignore', 'pipe', 'pipe'] });
    const timer = setTimeout(() => child.kill('SIGKILL'), limit);
    let [stdout, stderr, isInterrupted] = ['', '', false];
    child.stdout.on('data', (chunk: Buffer) => {
      stdout += chunk.toString();
      if (!interrupt || after === undefined || isInterrupted || !stdout.includes(after)) return;
      isInterrupted = true;
      child.kill(interrupt);
    });
    child.stderr.on('data', (chunk: Buffer) => {
      stderr += chunk.toString();
      if (interrupt && after === undefined) child.kill(interrupt);
    });
    child.on('error', reject);
    child.on('close', (status) => {
      clearTimeout(timer);
      resolve({ status, stdout, stderr });
    });
  });
}

/** Gives `work` a new empty folder and removes it afterwards. */
export async function inFolder<Result>(work: (folder: string) => Promise<Result>): Promise<Result> {
  const folder = mkdtempSync(join(tmpdir(), 'foldwright-'));
  try {
    return await work(folder);
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** Files of other people's that the project does not carry; null where they are missing. */
export function sharedFolder(): string | null {
  const here = fileURLToPath(new URL('../../../shared', import.meta.url));
  const folder = process.env['FOLDWRIGHT_SHARED'] ?? here;
  const found = existsSync(join(folder, 'models')) ? folder : null;
  return required(found, 'the folder of shared models');
}

/** A folder with a model in it. */
export function withModel(
  text: string,
  work: (folder: string, model: string) => Promise<void>,
): Promise<void> {
  return inFolder((folder) => {
    const model = join(folder, 'model.obj');
    writeFileSync(model, text);
    return work(folder, model);
  });
}

export interface WrittenReport {
  files: string[];
  options: Record<string, unknown>;
  parts: number;
  sheets: number;
  pieces: object[];
  segmentation: number[];
  result_hash: string;
}

export function readReport(path: string): WrittenReport {
  return JSON.parse(readFileSync(path, 'utf8')) as WrittenReport;
}
