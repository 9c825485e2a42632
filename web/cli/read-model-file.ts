import { readFileSync, statSync } from 'node:fs';
import { Exit, exitStatus } from './exit.js';

function reasonOf(error: unknown): string {
  const { code, message } = error as NodeJS.ErrnoException;
  if (code === 'ENOENT' || code === 'ENOTDIR') return 'there is no such file';
  if (code === 'EACCES' || code === 'EPERM') return 'may not be read';
  return `cannot be read: ${message}`;
}

/** The model could not be read or used. */
export function modelError(model: string, sentence: string): Exit {
  return new Exit(exitStatus.model, `${model}: ${sentence}`);
}

/**
 * The bytes of the model's file.
 * @throws Exit if there is no such file, or nothing in it
 */
export function readModelFile(model: string): Uint8Array {
  let bytes: Uint8Array;
  try {
    const status = statSync(model);
    if (status.isDirectory()) throw modelError(model, 'is a directory, not a model');
    // Reading from a device might never end.
    if (!status.isFile() && !status.isFIFO()) throw modelError(model, 'is not a file');
    bytes = readFileSync(model);
  } catch (error) {
    throw error instanceof Exit ? error : modelError(model, reasonOf(error));
  }
  if (bytes.length === 0) throw modelError(model, 'the file is empty');
  return bytes;
}
