import { describe, expect, it } from 'vitest';
import { readModelFiles, type PickedFile } from '../../web/app/model-file.js';
import { faultOf } from './unusable.js';

const picked = (content: string, path: string): PickedFile => ({
  path,
  file: new File([content], path),
});

/** A file that says that it has this size. */
function fileOf(size: number): PickedFile {
  const { path, file } = picked('solid', 'big.stl');
  return { path, file: Object.defineProperty(file, 'size', { value: size }) };
}

describe('readModelFiles', () => {
  it('refuses a file that is too large, with both sizes, before it reads it', async () => {
    const words = '“big.stl” is too large: it has 513 MB, and 512 MB can be read';
    expect(await faultOf(readModelFiles([fileOf(512 * 2 ** 20 + 1)]))).toContain(words);
    const { name, files } = await readModelFiles([fileOf(512 * 2 ** 20)]);
    expect([name, files[0]!.bytes.length]).toEqual(['big.stl', 5]);
  });

  it('refuses files that are too large together, or too many', async () => {
    const halves = [fileOf(256 * 2 ** 20), fileOf(257 * 2 ** 20)];
    expect(await faultOf(readModelFiles(halves))).toContain(
      'it has 513 MB, and 512 MB can be read',
    );
    const many = Array.from({ length: 1001 }, (_, i) => picked('', `${i}.png`));
    expect(await faultOf(readModelFiles(many))).toContain('it has more than 1000 files');
  });

  it('says what may be wrong with a file that cannot be read', async () => {
    const folder = picked('v', 'folder');
    folder.file.arrayBuffer = () => Promise.reject(new DOMException('gone', 'NotFoundError'));
    const words = '“folder” cannot be read: it is a folder';
    expect(await faultOf(readModelFiles([folder]))).toContain(words);
    expect(await faultOf(readModelFiles([picked('v', 'a.obj'), folder]))).toContain(words);
  });

  it('refuses none and an empty one', async () => {
    expect(await faultOf(readModelFiles([]))).toContain('That was no file');
    expect(await faultOf(readModelFiles([picked('', 'b.obj')]))).toContain('“b.obj” is empty');
  });

  it('keeps all files, and calls them as the model is called', async () => {
    const names = ['skull.mtl', 'textures/bone.png', 'skull.OBJ', 'empty.txt'];
    const chosen = await readModelFiles(names.map((name) => picked('v', name)));
    expect(chosen.name).toBe('skull.OBJ');
    expect(chosen.files.map(({ name }) => name)).toEqual(names);
  });
});
