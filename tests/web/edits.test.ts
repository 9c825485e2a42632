/** Parts are split and merged through workers, and nothing else of the files changes. */
import { describe, expect, it } from 'vitest';
import { runJob, type RunOptions, type TimedResult } from '../../web/core/client.js';
import { writeFold } from '../../web/export/fold.js';
import { defaultOptions } from '../../web/model/default-options.js';
import { isRenaming, merging, renamed, splitting, startFrom } from '../../web/model/edits.js';
import type { JobResult, Piece } from '../../web/model/job.js';
import type { JobOptions } from '../../web/model/job-options.js';
import { withoutLooks } from './engine-result.js';
import { checkFold } from './fold-check.js';
import { parseFold } from './fold-file.js';
import { objText, wavyRing } from './model-text.js';
import { isEngineBuilt, withThreads } from './thread-pool.js';

const bytes = new TextEncoder().encode(objText(wavyRing(12)));
// Of a fixed size, so that coordinates do not follow the largest piece.
const options = {
  ...defaultOptions,
  parts: 5,
  sizing: 'height',
  size: 100,
  compaction: false,
} as const;

function run(
  workers: number,
  runOptions: RunOptions = {},
  more: Partial<JobOptions> = {},
): Promise<TimedResult> {
  return withThreads(workers, async (pool) => {
    const files = [{ name: 'ring.obj', bytes }];
    return withoutLooks(await runJob(pool, files, { ...options, ...more }, runOptions));
  });
}

/** The result that all edits start from; how many workers make it does not matter. */
let earlier: Promise<TimedResult> | null = null;
const earlierResult = (): Promise<TimedResult> => (earlier ??= run(2));

/** All that is printed on the pieces. */
function texts({ pieces }: JobResult): string[] {
  return pieces.flatMap(({ labels }) => labels.map(({ text }) => text));
}

/**
 * What the FOLD file says of the pieces of each part, but for their place in the order of gluing and the turn that
 * packing gives them: distances to the first two corners instead of coordinates.
 */
function framesByPart(result: JobResult): Map<number, string[]> {
  const frames = new Map<number, string[]>();
  for (const frame of parseFold(writeFold(result)).nets) {
    const part = frame['foldwright:part'];
    const corners = frame.vertices_coords as [number, number][];
    const [first, second] = corners as [[number, number], [number, number]];
    const vertices_coords = corners.map((corner) =>
      [first, second].map((from) => distance(from, corner).toFixed(6)),
    );
    const text = JSON.stringify({
      ...frame,
      vertices_coords,
      frame_title: '',
      'foldwright:piece': 0,
    });
    frames.set(part, [...(frames.get(part) ?? []), text]);
  }
  return frames;
}

function distance([x, y]: [number, number], [u, v]: [number, number]): number {
  return Math.hypot(u - x, v - y);
}

/** Two parts that share an edge of the model. */
function touching({ labels, pieces }: JobResult): [number, number] {
  const partOf = new Map<number, number>();
  for (const { modelEdges, part } of pieces) {
    for (const edge of modelEdges) {
      const other = partOf.get(edge) ?? part;
      if (other !== part) return [Math.min(part, other), Math.max(part, other)];
      partOf.set(edge, part);
    }
  }
  throw new Error(`There is one part only, of ${labels.length} faces`);
}

describe('names of parts', () => {
  const names = [
    { part: 0, name: 'Head' },
    { part: 3, name: 'Leg' },
  ];

  it('are given, changed and taken back, in the order of parts', () => {
    expect(renamed(names, 1, 'Tail').map(({ part }) => part)).toEqual([0, 1, 3]);
    expect(renamed(names, 3, 'Tail')).toEqual([names[0], { part: 3, name: 'Tail' }]);
    expect(renamed(names, 0, '')).toEqual([names[1]]);
    expect(renamed(names, 1, '')).toEqual(names);
  });
});

describe.skipIf(!isEngineBuilt)('edits', () => {
  it('split a part and leave the nets and motions of all others as they are', async () => {
    const before = await earlierResult();
    const after = await run(2, { start: startFrom(before, [splitting(1, 3)]) });
    expect(after.parts).toBe(7);
    expect(checkFold(parseFold(writeFold(after)))).toEqual([]);
    const [old, now] = [framesByPart(before), framesByPart(after)];
    for (const part of [0, 2, 3, 4]) expect(now.get(part)).toEqual(old.get(part));
    expect(now.get(1)).not.toEqual(old.get(1));
    const made = after.labels.map((part) => (part > 4 ? 1 : part));
    expect(made).toEqual(before.labels);
  });

  it('merge parts and leave the nets and motions of all others as they are', async () => {
    const before = await earlierResult();
    const [a, b] = touching(before);
    const after = await run(1, { start: startFrom(before, [merging([a, b])]) });
    expect(after.parts).toBe(4);
    expect(checkFold(parseFold(writeFold(after)))).toEqual([]);
    const [old, now] = [framesByPart(before), framesByPart(after)];
    for (const part of [0, 1, 2, 3].filter((other) => other !== a && other !== b)) {
      expect(now.get(part)).toEqual(old.get(part));
    }
  });

  it('give the same whoever works on them', async () => {
    const before = await earlierResult();
    const start = startFrom(before, [splitting(2)]);
    const [one, three] = [await run(1, { start }), await run(3, { start })];
    expect(three.hash).toBe(one.hash);
    expect(await run(1, { start: startFrom(before, []) })).toMatchObject({ hash: before.hash });
  });

  it('name parts and change only the texts on paper', async () => {
    const before = await earlierResult();
    const names = [{ part: 2, name: 'Wing' }];
    const after = await run(2, { start: startFrom(before, []) }, { names });
    expect(after.names).toEqual(names);
    expect(after.search.moves).toBe(0);
    expect(after.nets).toEqual(before.nets);
    expect(isRenaming(before, after)).toBe(true);
    const untold = ({ name, labels, ...rest }: Piece): unknown => [
      rest,
      typeof name,
      typeof labels,
    ];
    expect(after.pieces.map(untold)).toEqual(before.pieces.map(untold));
    const letter = before.pieces.find(({ part }) => part === 2)!.name;
    const namesIt = (text: string): boolean => new RegExp(`^${letter}\\d+$`).test(text);
    expect(texts(before).filter(namesIt)).not.toHaveLength(0);
    expect(texts(after).filter(namesIt)).toHaveLength(0);
    expect(after.pieces.filter(({ name }) => name === 'Wing')).toMatchObject([{ part: 2 }]);
    expect(texts(after).some((text) => /^Wing:\d+$/.test(text))).toBe(true);
    expect(writeFold(after)).toContain('"Piece Wing"');
  });

  it('leave names with the parts that stay', async () => {
    const before = await earlierResult();
    const names = [0, 1, 2, 3, 4].map((part) => ({ part, name: `No. ${part}` }));
    const after = await run(1, { start: startFrom(before, [splitting(1)]) }, { names });
    expect(isRenaming(before, after)).toBe(false);
    expect(after.names).toEqual(names.filter(({ part }) => part !== 1));
    const letters = after.pieces.filter(({ part }) => part === 1 || part === 5);
    for (const { name } of letters) expect(name).toMatch(/^[A-Z]$/);
  });

  it.each([
    ['seventeen letters', 'must have 1 to 16 characters, and no space around them'],
    ['a\tb', 'must not hold control characters'],
  ])('refuse %j as a name in one sentence', async (name, fault) => {
    const names = [{ part: 0, name }];
    await expect(run(1, {}, { names })).rejects.toMatchObject({
      code: 'bad-option',
      message: `the name of a part ${fault}`,
    });
  });

  it('refuse the same name for two parts', async () => {
    const names = [0, 1].map((part) => ({ part, name: 'Leg' }));
    await expect(run(1, {}, { names })).rejects.toMatchObject({
      message: 'two parts cannot have the same name, "Leg"',
    });
  });

  it('are refused in one sentence when they cannot be made', async () => {
    const before = await earlierResult();
    await expect(run(1, { start: startFrom(before, [splitting(9)]) })).rejects.toMatchObject({
      code: 'bad-edit',
      message: 'there is no part 10: the model has 5 parts',
    });
    const labels = before.labels.slice(1);
    await expect(run(1, { start: { ...startFrom(before, []), labels } })).rejects.toMatchObject({
      code: 'bad-start',
    });
  });
});
