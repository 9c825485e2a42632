import { describe, expect, it } from 'vitest';
import { readModelFile } from '../../web/app/model-file.js';

/** A file that says that it has this size. */
function fileOf(size: number): File {
  return Object.defineProperty(new File(['solid'], 'big.stl'), 'size', { value: size });
}

describe('readModelFile', () => {
  it('refuses a file that is too large, with both sizes, before it reads it', async () => {
    const words = '“big.stl” is too large: it has 513 MB, and 512 MB can be read';
    await expect(readModelFile([fileOf(512 * 2 ** 20 + 1)])).rejects.toThrow(words);
    const { name, bytes } = await readModelFile([fileOf(512 * 2 ** 20)]);
    expect([name, bytes.length]).toEqual(['big.stl', 5]);
  });

  it('says what may be wrong with a file that cannot be read', async () => {
    const file = new File(['v'], 'folder');
    file.arrayBuffer = () => Promise.reject(new DOMException('gone', 'NotFoundError'));
    await expect(readModelFile([file])).rejects.toThrow('“folder” cannot be read: it is a folder');
  });

  it('refuses none, several and an empty one', async () => {
    const [file, empty] = [new File(['v'], 'a.obj'), new File([], 'b.obj')];
    await expect(readModelFile([])).rejects.toThrow('That was no file');
    await expect(readModelFile([file, file])).rejects.toThrow('Those were 2 files');
    await expect(readModelFile([empty])).rejects.toThrow('“b.obj” is empty');
  });
});
