import { readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { expect } from 'vitest';
import { foldwright, inFolder } from '../web/command.js';
import { objText, wavyRing } from '../web/model-text.js';

/** A small model. */
export const ring = objText(wavyRing(8));

const options = ['--parts', '3', '--seed', '2'];

/** What the command line makes of the ring in 3 parts with seed 2: the FOLD file and the hash of its result. */
export function unfoldedRing(): Promise<{ fold: string; hash: string }> {
  return inFolder(async (folder) => {
    const [model, fold, report] = ['ring.obj', 'ring.fold', 'ring.json'].map((name) =>
      join(folder, name),
    );
    await writeFile(model!, ring);
    const ended = await foldwright([model!, ...options, '-o', fold!, '--report', report!]);
    expect(ended.status).toBe(0);
    const { result_hash } = JSON.parse(await readFile(report!, 'utf8')) as { result_hash: string };
    return { fold: await readFile(fold!, 'utf8'), hash: result_hash };
  });
}
