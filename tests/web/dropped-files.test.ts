/** Drops of files and folders; browsers let no test make entries, so these are imitations. */
import { describe, expect, it } from 'vitest';
import { droppedFiles } from '../../web/app/dropped-files.js';
import { faultOf } from './unusable.js';

type Tree = string | { [name: string]: Tree };

/** An entry of a file with this text, or of a folder with these entries, given two at a time. */
function entryOf(name: string, tree: Tree): FileSystemEntry {
  if (typeof tree === 'string') {
    const file = (resolve: (file: File) => void): void => resolve(new File([tree], name));
    return { name, isFile: true, isDirectory: false, file } as unknown as FileSystemEntry;
  }
  const entries = Object.entries(tree).map(([child, below]) => entryOf(child, below));
  const createReader = () => {
    let given = 0;
    return {
      readEntries: (resolve: (portion: FileSystemEntry[]) => void) =>
        resolve(entries.slice(given, (given += 2))),
    };
  };
  return { name, isFile: false, isDirectory: true, createReader } as unknown as FileSystemEntry;
}

function drop(things: Record<string, Tree>): DataTransfer {
  const items = Object.entries(things).map(([name, tree]) => ({
    kind: 'file',
    webkitGetAsEntry: () => entryOf(name, tree),
    getAsFile: () => new File([typeof tree === 'string' ? tree : ''], name),
  }));
  return { items: [...items, { kind: 'string' }] } as unknown as DataTransfer;
}

const pathsOf = async (things: Record<string, Tree>): Promise<string[]> =>
  (await droppedFiles(drop(things))).map(({ path }) => path);

describe('droppedFiles', () => {
  it('gives several files by their names', async () => {
    expect(await pathsOf({ 'a.obj': 'v', 'a.mtl': 'newmtl' })).toEqual(['a.obj', 'a.mtl']);
  });

  it('gives all files of a folder by their path in it, but hidden ones', async () => {
    const folder = {
      '.DS_Store': 'x',
      'a.obj': 'v',
      textures: { 'b.png': 'b', deep: { 'c.png': 'c' }, '.git': { config: 'x' } },
      'd.mtl': 'd',
    };
    const paths = ['a.obj', 'textures/b.png', 'textures/deep/c.png', 'd.mtl'];
    expect(await pathsOf({ skull: folder })).toEqual(paths);
  });

  it('stops where nobody wants so many', async () => {
    const names = Array.from({ length: 3000 }, (_, i) => [`${i}.png`, 'x'] as const);
    expect((await pathsOf({ pictures: Object.fromEntries(names) })).length).toBe(1001);
  });

  it('says which folder cannot be read', async () => {
    const locked = entryOf('locked', {}) as unknown as { createReader: () => unknown };
    locked.createReader = () => ({
      readEntries: (_: unknown, reject: (error: Error) => void) => reject(new Error('NotReadable')),
    });
    const item = { kind: 'file', webkitGetAsEntry: () => locked, getAsFile: () => null };
    const transfer = { items: [item] } as unknown as DataTransfer;
    expect(await faultOf(droppedFiles(transfer))).toContain('“locked” cannot be read');
  });
});
