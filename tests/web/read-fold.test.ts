/** FOLD files as models: which frame is unfolded, and what is told of those that have none. */
import { describe, expect, it } from 'vitest';
import { writeFold } from '../../web/export/fold.js';
import type { ModelFile } from '../../web/model/model-files.js';
import { formatOf, needsReader } from '../../web/read/format.js';
import { cubeResult } from './fixtures.js';
import { codesOf, read, refusal, sizeOf, trianglesOf, volumeOf } from './read-model.js';
import { zip } from './zips.js';

const bytesOf = (text: string): Uint8Array => new TextEncoder().encode(text);

function foldFile(content: object | string, name = 'x.fold'): ModelFile {
  return { name, bytes: bytesOf(typeof content === 'string' ? content : JSON.stringify(content)) };
}

/** Two crossing bars folded to a tent of four corners: a tetrahedron of height 2 without its base. */
const tent = {
  vertices_coords: [
    [0, 0, 0],
    [3, 0, 0],
    [0, 0, 3],
    [1, 2, 1],
  ],
  faces_vertices: [
    [0, 3, 1],
    [1, 3, 2],
    [2, 3, 0],
  ],
};

const pattern = {
  frame_classes: ['creasePattern'],
  vertices_coords: [
    [0, 0],
    [1, 0],
    [1, 1],
  ],
  edges_vertices: [
    [0, 1],
    [1, 2],
    [2, 0],
  ],
  edges_assignment: ['B', 'B', 'B'],
  faces_vertices: [[0, 1, 2]],
};

const obj: ModelFile = { name: 'a.obj', bytes: bytesOf('v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n') };

describe('readFold', () => {
  it('takes the folded form that Foldwright has written, and tells that its nets are not used', async () => {
    const result = cubeResult();
    const model = await read(foldFile(writeFold(result)));
    const found = trianglesOf(model.file);
    expect(found.positions).toEqual([...result.model.vertices]);
    expect(found.corners).toEqual([...result.model.faces]);
    expect(model.usual).toEqual({ up: 'y', unit: 'mm' });
    expect(model.notices).toEqual([{ code: 'fold-nets-unused', params: { pieces: 1 } }]);
  });

  it.each([
    ['as key frame', { frame_classes: ['foldedForm'], frame_unit: 'in', ...tent }],
    [
      'behind its pattern',
      { ...pattern, file_frames: [{ frame_classes: ['foldedForm'], ...tent }] },
    ],
    ['without a class', { file_spec: 1.1, ...tent }],
    [
      'that has its faces from the pattern',
      {
        ...pattern,
        faces_vertices: tent.faces_vertices,
        file_frames: [
          {
            frame_inherit: true,
            frame_parent: 0,
            frame_classes: ['foldedForm'],
            vertices_coords: tent.vertices_coords,
          },
        ],
      },
    ],
  ])('takes a folded form of another program %s', async (_, content) => {
    const model = await read(foldFile(content));
    const found = trianglesOf(model.file);
    expect(sizeOf(found)).toEqual([3, 2, 3]);
    expect(volumeOf(found)).toBeCloseTo(3);
    expect(codesOf(model)).toEqual([]);
    expect(model.usual).toEqual('frame_unit' in content ? { unit: 'in' } : {});
  });

  it('keeps faces with more corners than three', async () => {
    const square = [
      [0, 0, 0],
      [1, 0, 0],
      [1, 1, 0],
      [0, 1, 1],
    ];
    const model = await read(foldFile({ vertices_coords: square, faces_vertices: [[0, 1, 2, 3]] }));
    expect(trianglesOf(model.file).sides).toEqual([4]);
  });

  it.each([
    [pattern, "'x.fold' has only a flat crease pattern, and the folded model is missing"],
    [{ ...pattern, frame_classes: ['foldedForm'] }, "the folded form in 'x.fold' is flat"],
    [{ file_spec: 1.2 }, "'x.fold' is a FOLD file without a model"],
    [{ ...tent, faces_vertices: undefined }, "in frame 0 'faces_vertices' is missing"],
    [{ ...tent, faces_vertices: [[0, 1]] }, "entry 0 of 'faces_vertices' is no list of 3 or more"],
    [{ ...tent, faces_vertices: [[0, 1, -1]] }, "entry 0 of 'faces_vertices' is the number -1"],
    [{ ...tent, file_frames: [7] }, 'frame 1 holds something else than fields'],
    [{ ...tent, file_frames: 7 }, "in frame 0 'file_frames' holds something else than it should"],
    ['{"vertices_coords": [[0, 0, NaN]]}', "in line 1, at character 29, stands 'NaN' where"],
    ['{"vertices_coords":\n[[0 0]]}', "in line 2, at character 5, stands '0' where"],
    [
      '{"vertices_coords": [[0, 0, 1e999], [0, 0, 1]]}',
      "entry 0 of 'vertices_coords' is no number",
    ],
    ['{"file_spec": 1.2, "vertices_co', "'x.fold' is cut off: its end is missing"],
    ['solid', "'x.fold' is cut off"],
    ['<svg/>', "in line 1, at character 1, stands '<' where something else is expected"],
  ])('refuses what has none in one sentence (%#)', async (content, words) => {
    expect(await refusal([foldFile(content)])).toContain(words);
  });

  it('knows FOLD files by their contents, whatever they are called', () => {
    expect(formatOf(foldFile(tent).bytes)).toBe('fold');
    expect(formatOf(foldFile(writeFold(cubeResult())).bytes)).toBe('fold');
    expect(formatOf(bytesOf('{"asset": {"version": "2.0"}, "file_spec": 1}'))).toBe('gltf');
    expect(formatOf(bytesOf('{"name": "a list of settings"}'))).toBe(null);
  });

  it('takes them for the model only where there is no other', async () => {
    const fold = foldFile(tent);
    expect(needsReader([obj, fold])).toBe(false);
    expect(needsReader([fold])).toBe(true);
    const picture = { name: 'a.png', bytes: Uint8Array.of(1) };
    expect((await read(fold, picture)).name).toBe('x.fold');
    const archive = zip('a.zip', {
      'a.obj': new TextDecoder().decode(obj.bytes),
      'b.fold': fold.bytes,
    });
    expect((await read(archive)).name).toBe('a.obj');
    expect((await read(zip('a.zip', { 'nets/b.fold': fold.bytes }))).name).toBe('nets/b.fold');
    expect(await refusal([fold, foldFile(tent, 'y.fold')])).toContain('y.fold');
  });
});
