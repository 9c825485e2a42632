/** Nets that a file brings along, from its bytes to pieces on paper. */
import { describe, expect, it } from 'vitest';
import { Session } from '../../web/api/session.js';
import type { Options } from '../../web/api/written-options.js';
import type { Pool } from '../../web/core/pool.js';
import type { JobResult, Piece } from '../../web/model/job.js';
import { keptNets } from '../../web/model/kept-nets.js';
import { cube, halves, halvesFile, pdoFile, type PdoBody, type PdoSpec } from './pdo-files.js';
import { objText, wavyRing } from './model-text.js';
import { read } from './read-model.js';
import { isEngineBuilt, withThreads } from './thread-pool.js';

const none = (): Promise<Uint8Array> => Promise.reject(new Error('not needed here'));

/** The cube as triangles around the origin, as the engine tells it. */
const triangles = {
  vertices: cube.vertices.flat().map((value) => value - 5),
  faces: cube.faces.flatMap(([a, b, c, d]) => [a, b, c, a, c, d] as number[]),
};

async function keptOf(body: PdoBody): Promise<ReturnType<typeof keptNets>> {
  const { nets } = await read(pdoFile({ bodies: [body] }));
  return keptNets(nets!, triangles, 'y');
}

describe('keptNets', () => {
  it('gives triangles the nets of their faces, and cuts what the file cuts', async () => {
    const { labels, count, locks, uncut } = (await keptOf(halves))!;
    expect([...labels]).toEqual([0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1]);
    expect([count, locks.length, uncut]).toEqual([2, 8, 0]);
  });

  it('says which side of a cut bears a flap', async () => {
    const { flapEdges } = (await keptOf(halves))!;
    expect(flapEdges).toHaveLength(8);
    // From 1 to 0 runs the edge of the first face that has it, and a flap: its left one.
    for (const { from, to, flaps, height } of flapEdges) {
      const first = cube.faces.find((face) => face.includes(from) && face.includes(to))!;
      const isAlong = first[(first.indexOf(from) + 1) % 4] === to;
      expect([flaps, height]).toEqual([isAlong ? 'left' : 'right', 6]);
    }
    expect((await keptOf({ ...halves, flap: 0 }))!.flapEdges).toEqual([]);
  });

  it('finds turned files, and none that were repaired to other faces', async () => {
    const { nets } = await read(pdoFile({ bodies: [halves] }));
    const turned = triangles.vertices.map((_, i, all) => {
      const at = i - (i % 3);
      return [all[at]!, all[at + 2]!, -all[at + 1]!][i % 3]!;
    });
    expect(keptNets(nets!, { ...triangles, vertices: turned }, 'z')!.count).toBe(2);
    const moved = triangles.vertices.map((value, i) => (i === 1 ? value + 1 : value));
    expect(keptNets(nets!, { ...triangles, vertices: moved }, 'y')).toBeNull();
  });
});

async function run(pool: Pool, spec: PdoSpec, options: Options): Promise<Session> {
  const files = [pdoFile(spec)];
  const session = new Session(files, { pool: () => pool, loadFont: none, loadRenderer: none });
  await session.run(options);
  return session;
}

/** The face of the cube that a face of the model is a share of. */
function sideOf({ model }: JobResult, face: number): number {
  const ends = [...model.faces.slice(3 * face, 3 * face + 3)];
  return [2, 2, 1, 1, 0, 0].findIndex((axis, side) => {
    const values = ends.map((vertex) => model.vertices[3 * vertex + axis]!);
    return values.every(
      (value) => Math.abs(value - values[0]!) < 1e-6 && value > 0 === side % 2 > 0,
    );
  });
}

/** Pairs of faces of the model between which a piece goes on, over edges of these kinds. */
function joinedPairs(
  { edges, assignments, faces, sources }: Piece,
  letters: string,
): [number, number][] {
  return [...assignments].flatMap((letter, edge) => {
    if (!letters.includes(letter)) return [];
    const ends = [edges[2 * edge]!, edges[2 * edge + 1]!];
    const beside = [...sources].filter((_, face) =>
      ends.every((end) => faces.subarray(3 * face, 3 * face + 3).includes(end)),
    );
    return [beside.sort((a, b) => a - b) as [number, number]];
  });
}

/** Pairs of sides of the cube between which a piece folds. */
function foldsOf(result: JobResult, piece: Piece): string[] {
  return joinedPairs(piece, 'MV').map((pair) => {
    return pair
      .map((source) => sideOf(result, source))
      .sort()
      .join(' ');
  });
}

const codes = ({ notices }: JobResult): string[] => notices.map(({ code }) => code);

describe.skipIf(!isEngineBuilt)('nets of a file', () => {
  it('are kept with folds, flaps and size, and can be edited', () =>
    withThreads(1, async (pool) => {
      const session = await run(pool, halvesFile, { nets: 'file' });
      const result = await session.result();
      const folds = result.pieces.flatMap((piece) => foldsOf(result, piece));
      expect(folds.sort()).toEqual(['0 2', '0 4', '1 3', '1 5']);
      expect(result.pieces.map(({ cause, foldable }) => [cause, foldable])).toEqual([
        ['part', 'line'],
        ['part', 'line'],
      ]);
      expect(result.scale).toBe(3);
      expect(result.flaps).toMatchObject({ wanted: 8, full: 8 });
      const params = { pieces: 2, uncut: 0, size: 'file' };
      expect(result.notices).toContainEqual({ code: 'file-nets-kept', params });
      // What the file cuts is not locked.
      const made = await session.apply({ kind: 'merge', parts: [1, 2] });
      expect(made.ok).toBe(true);
      const { notices, pieces } = await session.result();
      expect(pieces).toHaveLength(1);
      // What became of the nets of the file is still to be known.
      expect(notices).toContainEqual(result.notices.find(({ code }) => code === 'file-nets-kept'));
      await session.apply({ kind: 'paper', options: { height: 30 } });
      const kept = { pieces: 2, uncut: 0, size: 'other' };
      const sized = (await session.result()).notices;
      expect(sized.filter(({ code }) => code === 'file-nets-kept')).toEqual([
        { code: 'file-nets-kept', params: kept },
      ]);
    }));

  it('say that their parts hold, whatever number was asked for', () =>
    withThreads(1, async (pool) => {
      const session = await run(pool, halvesFile, { nets: 'file', parts: 5 });
      const { notices, pieces } = await session.result();
      expect(pieces).toHaveLength(2);
      expect(notices).toContainEqual({ code: 'parts-unused', params: { parts: 5 } });
      const usual = await (await run(pool, halvesFile, { nets: 'file' })).result();
      expect(codes(usual)).not.toContain('parts-unused');
    }));

  it('come back as they were found, of a model in several parts', () =>
    withThreads(2, async (pool) => {
      const text = objText(wavyRing(8));
      const files = [{ name: 'ring.obj', bytes: new TextEncoder().encode(text) }];
      const session = new Session(files, { pool: () => pool, loadFont: none, loadRenderer: none });
      await session.run({ parts: 5, runs: 50 });
      const { model, pieces } = await session.result();
      const threes = (values: ArrayLike<number>): number[][] =>
        Array.from({ length: values.length / 3 }, (_, i) =>
          [0, 1, 2].map((k) => values[3 * i + k]!),
        );
      const joined = pieces.flatMap((piece) => joinedPairs(piece, 'MVF'));
      const body = { vertices: threes(model.vertices), faces: threes(model.faces), joined };
      const pattern = {
        scale: 1,
        parts: pieces.map(({ width, height }) => [width, height] as const),
      };
      const again = await (await run(pool, { bodies: [body], pattern }, { nets: 'file' })).result();
      const foundAgain = again.pieces.flatMap((piece) => joinedPairs(piece, 'MVF'));
      const sorted = (pairs: [number, number][]): string[] => pairs.map(String).sort();
      expect(sorted(foundAgain)).toEqual(sorted(joined));
      expect(again.pieces).toHaveLength(pieces.length);
      expect(again.scale).toBe(1);
      expect(again.pieces.every(({ overlaps }) => overlaps === 0)).toBe(true);
    }));

  it('come out the same every time', () =>
    withThreads(2, async (pool) => {
      const hashes: string[] = [];
      for (const _ of [1, 2]) {
        hashes.push((await (await run(pool, halvesFile, { nets: 'file' })).result()).hash);
      }
      expect(hashes[0]).toBe(hashes[1]);
    }));

  it('are told of where nobody keeps them', () =>
    withThreads(1, async (pool) => {
      const result = await (await run(pool, halvesFile, {})).result();
      expect(result.notices[0]).toEqual({ code: 'file-nets-unused', params: { pieces: 2 } });
    }));

  it('give way to new ones where they cannot be kept', () =>
    withThreads(1, async (pool) => {
      const lost = async (spec: PdoSpec, options: Options): Promise<unknown> =>
        (await (await run(pool, spec, { nets: 'file', ...options })).result()).notices[0];
      const code = 'file-nets-lost';
      expect(await lost(halvesFile, { faces: 8 })).toEqual({
        code,
        params: { what: 'simplified' },
      });
      expect(await lost({ pattern: null }, {})).toEqual({ code, params: { what: 'none' } });
    }));

  it('stay whole in flat faces', () =>
    withThreads(1, async (pool) => {
      // Each side of the cube in two triangles, all of which the file cuts apart but on one side.
      const faces = cube.faces.flatMap(([a, b, c, d]) => [
        [a!, b!, c!],
        [a!, c!, d!],
      ]);
      const joined = [[0, 1] as const, [2, 3] as const];
      const session = await run(pool, { bodies: [{ ...cube, faces, joined }] }, { nets: 'file' });
      const result = await session.result();
      expect(result.pieces).toHaveLength(6);
      const params = { pieces: 6, uncut: 4, size: 'file' };
      expect(result.notices).toContainEqual({ code: 'file-nets-kept', params });
      expect(codes(result)).not.toContain('file-nets-lost');
    }));

  it('that do not fit on the paper at their size become as large as it allows', () =>
    withThreads(1, async (pool) => {
      const spec: PdoSpec = { ...halvesFile, pattern: { scale: 30, parts: [[700, 700]] } };
      const result = await (await run(pool, spec, { nets: 'file' })).result();
      expect(result.pieces).toHaveLength(2);
      expect(result.scale).toBeLessThan(30);
      expect(result.sheets.length).toBeLessThanOrEqual(2);
    }));

  it('that would be cut at their size become as large as the paper allows, too', () =>
    withThreads(1, async (pool) => {
      // The file lies: its pieces are larger than it says.
      const pattern = { scale: 12, parts: [[70, 70] as const] };
      const session = await run(pool, { bodies: [cube], pattern }, { nets: 'file' });
      const result = await session.result();
      expect(result.pieces.map(({ cause }) => cause)).toEqual(['part']);
      const params = { pieces: 1, uncut: 0, size: 'other' };
      expect(result.notices).toContainEqual({ code: 'file-nets-kept', params });
      expect((await session.state()).wishes.settings.scale).toBe('none');
    }));
});
