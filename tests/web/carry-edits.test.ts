/** The edits of a document, made again for a corrected model by the engine. */
import { readFile } from 'node:fs/promises';
import { expect, it } from 'vitest';
import { carryEdits } from '../../web/api/carry-edits.js';
import { makeDoor } from '../../web/api/door.js';
import type { Session } from '../../web/api/session.js';
import type { Pool } from '../../web/core/pool.js';
import type { DocumentEdit } from '../../web/model/document-edits.js';
import { objText, wavyRing } from './model-text.js';
import { readRenderer } from './printed.js';
import { isEngineBuilt, withThreads } from './thread-pool.js';

const ring = wavyRing(8);
const options = { parts: 3, compact: 'off', runs: 40 } as const;

const fonts = new URL('../../dist/cli/fonts/', import.meta.url);

async function unfolded(pool: Pool, mesh: typeof ring): Promise<Session> {
  const door = makeDoor({
    startPool: () => pool,
    loadFont: async (file) => readFile(new URL(file, fonts)),
    loadRenderer: readRenderer,
  });
  const bytes = new TextEncoder().encode(objText(mesh));
  const session = await door.open([{ name: 'ring.obj', bytes }], { pool });
  await session.run(options);
  return session;
}

/** The vertex that is farthest along x. */
function farthest(vertices: ArrayLike<number>): number {
  let best = 0;
  for (let i = 3; i < vertices.length; i += 3) if (vertices[i]! > vertices[best]!) best = i;
  return best / 3;
}

/** An edge of a face with a vertex, or of the first face without it. */
function edgeOf(faces: Int32Array, isWanted: (corners: Int32Array) => boolean): [number, number] {
  for (let at = 0; at < faces.length; at += 3) {
    const corners = faces.subarray(at, at + 3);
    if (isWanted(corners)) return [corners[0]!, corners[1]!];
  }
  throw new Error('There is no such face');
}

it.skipIf(!isEngineBuilt)('makes edits again where they fit, and names the others', () =>
  withThreads(1, async (pool) => {
    const session = await unfolded(pool, ring);
    const { faces, vertices } = (await session.result()).model;
    const tip = farthest(vertices);
    const near = edgeOf(faces, ([v, w]) => v === tip || w === tip);
    const away = edgeOf(faces, (corners) => !corners.includes(tip));
    const edits: DocumentEdit[] = [
      { kind: 'name', part: 1, text: 'Head' },
      { kind: 'flap', edge: away, side: 'none' },
      { kind: 'flap', edge: near, side: 'none' },
      { kind: 'paper', options: { paper: 'A3' } },
      { kind: 'name', part: 2, text: 'Tail' },
    ];
    for (const edit of edits) expect(await session.apply(edit)).toMatchObject({ ok: true });
    session.undo();

    const same = await unfolded(pool, ring);
    expect(await carryEdits(session, same)).toEqual({ kept: 4, lost: [] });
    expect(same.edits).toEqual(session.edits);
    expect((await same.result()).hash).toBe((await session.result()).hash);
    // The document that they come from is as it was, with what was undone.
    expect([session.position, session.canRedo]).toEqual([4, true]);

    // The tip goes farther out, and all else stays.
    const spiked = { ...ring, vertices: ring.vertices.map((point) => [...point]) };
    spiked.vertices[farthest(ring.vertices.flat())]![0]! += 20;
    const other = await unfolded(pool, spiked);
    const { kept, lost } = await carryEdits(session, other);
    expect(lost).toContainEqual(
      expect.objectContaining({
        edit: edits[2],
        reason: { code: 'edit-place-gone', params: { what: 'edge' } },
      }),
    );
    expect(kept + lost.length).toBe(4);
    expect(other.edits).toHaveLength(kept);
    expect(other.edits).toContainEqual(edits[3]);
    expect(other.edits.find(({ kind }) => kind === 'flap')).toEqual(edits[1]);

    const ended = AbortSignal.abort();
    await expect(carryEdits(session, other, { signal: ended })).rejects.toThrow();
    expect(session.position).toBe(4);
  }),
);
