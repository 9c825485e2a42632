/** What is read of the nets in FOLD files: the model and pieces that they were written from. */
import { describe, expect, it } from 'vitest';
import { writeFold } from '../../web/export/fold.js';
import { cutPairs } from '../../web/model/borders.js';
import {
  canFold,
  labelsOf,
  readFoldedNets,
  type FoldedNets,
} from '../../web/read/fold/folded-nets.js';
import { Unreadable } from '../../web/read/unreadable.js';
import { FoldingStage } from '../../web/view/folding-stage.js';
import { englishPhrase } from '../../web/words/phrase.js';
import { numbers } from './damage.js';
import { boxAndLidResult, cubeResult, slitResult, tetrahedronResult } from './fixtures.js';

const results = {
  cube: cubeResult(),
  'box and lid': boxAndLidResult(),
  slit: slitResult(),
  tetrahedron: tetrahedronResult(),
};

function read(text: string): FoldedNets | null {
  return readFoldedNets({ name: 'x.fold', bytes: new TextEncoder().encode(text) });
}

/** A file with one frame changed; the frames count from 0, the key frame. */
function changed(frame: number, change: Record<string, unknown>): string {
  const file = JSON.parse(writeFold(results.cube)) as { file_frames: object[] };
  Object.assign(frame === 0 ? file : file.file_frames[frame - 1]!, change);
  return JSON.stringify(file);
}

/** Why a text is refused, without what helps. */
function fault(text: string): string {
  try {
    read(text);
    return 'read';
  } catch (error) {
    if (!(error instanceof Unreadable)) throw error;
    return englishPhrase(error)
      .replace(/^'x\.fold' is damaged: /, '')
      .replace(/; get the file.*/, '');
  }
}

describe('readFoldedNets', () => {
  it.each(Object.entries(results))('reads the %s as it was written', (_, result) => {
    const nets = read(writeFold(result))!;
    expect(nets.model.vertices).toEqual(result.model.vertices);
    expect(nets.model.faces).toEqual(result.model.faces);
    nets.pieces.forEach((piece, i) => {
      const { assignments, edges, faces, foldAngles, motion, part, sources, vertices } =
        result.pieces[i]!;
      expect(piece).toMatchObject({
        assignments,
        edges,
        faces,
        foldAngles,
        part,
        sources,
        vertices,
      });
      // JSON has no -0.
      expect(piece.motion).toEqual(
        motion && { ...motion, angles: motion.angles.map((angle) => angle + 0) },
      );
    });
    expect(cutPairs(nets.pieces)).toEqual(cutPairs(result.pieces));
    expect(canFold(nets)).toBe(true);
    expect(labelsOf(nets)).toEqual(Int32Array.from(result.labels));
    const { model, pieces } = nets;
    expect(() => new FoldingStage({ model, pieces: [...pieces] })).not.toThrow();
  });

  it('leaves files without nets to others', () => {
    const other = { file_spec: 1.2, vertices_coords: [[0, 0]], file_frames: [] };
    expect(read(JSON.stringify(other))).toBe(null);
  });

  it.each([
    [changed(1, { vertices_coords: undefined }), "'x.fold' has only a flat crease pattern, and"],
    [changed(1, { faces_vertices: undefined }), "in frame 1 'faces_vertices' is missing"],
    [changed(1, { faces_vertices: 7 }), "in frame 1 'faces_vertices' holds something else than it"],
    [
      changed(1, { faces_vertices: [[0, 1, 8]] }),
      "in frame 1 entry 0 of 'faces_vertices' is the number 8, where only 0 to 7 are there",
    ],
    [
      changed(2, { edges_assignment: ['B'] }),
      "in frame 2 'edges_assignment' has 1 entry where 25 are expected",
    ],
    [
      changed(2, {
        vertices_coords: [
          [0, 0],
          ['x', 0],
        ],
      }),
      "in frame 2 entry 1 of 'vertices_coords' is no number",
    ],
    [
      changed(2, { vertices_coords: [[0, 0], [0]] }),
      "in frame 2 entry 1 of 'vertices_coords' is no list of 2 numbers",
    ],
    [
      changed(2, { 'foldwright:motion': { root: 0, t: [0, 0.5], angles: [] } }),
      "in frame 2 the times in 'foldwright:motion' do not rise from 0 to 1",
    ],
    ['', "'x.fold' is cut off: its end is missing"],
    ['null', "'x.fold' is no FOLD file, whatever its name says"],
  ])('tells what is wrong, and where (%#)', (text, words) => {
    expect(fault(text)).toContain(words);
  });

  it('refuses files with other numbers in them, or takes them as they are', () => {
    const text = writeFold(results['box and lid']);
    const next = numbers(7);
    for (let i = 0; i < 300; ++i) {
      const at = next(text.length);
      const damaged = text.slice(0, at) + '9-,]"[e'[next(7)] + text.slice(at + 1);
      try {
        const { model, pieces } = read(damaged) ?? { model: null, pieces: [] };
        for (const { sources } of pieces) {
          for (const face of sources) expect(face).toBeLessThan(model!.faces.length / 3);
        }
      } catch (error) {
        expect(error).toBeInstanceOf(Unreadable);
      }
    }
  });

  it('says of a file that is cut off anywhere that its end is missing', () => {
    const text = writeFold(results.cube).trimEnd();
    const next = numbers(11);
    for (let i = 0; i < 200; ++i) {
      const end = 1 + next(text.length - 1);
      expect(fault(text.slice(0, end)), `cut at ${end}`).toContain('is cut off');
    }
  });
});
