/** A look at a model before it is unfolded, through workers. */
import { describe, expect, it } from 'vitest';
import { makeDoor } from '../../web/api/door.js';
import type { Session } from '../../web/api/session.js';
import type { Pool } from '../../web/core/pool.js';
import { cube } from './fixtures.js';
import { objText, wavyRing } from './model-text.js';
import { readRenderer } from './printed.js';
import { isEngineBuilt, withThreads } from './thread-pool.js';

const loadFont = (): Promise<Uint8Array> => Promise.reject(new Error('nothing is drawn here'));

function opened(pool: Pool, text: string, name = 'model.obj'): Promise<Session> {
  const { open } = makeDoor({ startPool: () => pool, loadFont, loadRenderer: readRenderer });
  return open([{ name, bytes: new TextEncoder().encode(text) }], { pool });
}

/** A cube that is moved to the right by `x` and made smaller. */
function movedCube(x: number, size: number): { vertices: number[][]; faces: number[][] } {
  const vertices = cube.vertices.map((p) => [size * p[0]! + x, size * p[1]!, size * p[2]!]);
  return { vertices, faces: cube.faces };
}

/** Several bodies in one file. */
function together(...bodies: { vertices: number[][]; faces: number[][] }[]): string {
  const vertices: number[][] = [];
  const faces: number[][] = [];
  for (const body of bodies) {
    const first = vertices.length;
    vertices.push(...body.vertices);
    faces.push(...body.faces.map((face) => face.map((vertex) => vertex + first)));
  }
  return objText({ vertices, faces });
}

describe.skipIf(!isEngineBuilt)('inspect', () => {
  it('tells what a model is, and what a number of faces makes of it', () =>
    withThreads(2, async (pool) => {
      const session = await opened(pool, objText(wavyRing(40)), 'models/ring.obj');
      const whole = await session.inspect();
      expect(whole.file).toBe('models/ring.obj');
      expect(whole.model.faces).toHaveLength(3 * 3200);
      expect(whole.components).toMatchObject([{ faces: 3200 }]);
      const simple = await session.inspect({ faces: 500 });
      expect(simple.model.faces.length / 3).toBeLessThanOrEqual(500);
      expect(simple.componentOfFaces).toHaveLength(simple.model.faces.length / 3);
    }));

  it('leaves workers and document as they are for the run that follows', () =>
    withThreads(2, async (pool) => {
      const session = await opened(pool, objText(wavyRing(8)));
      const { model } = await session.inspect({ faces: 100 });
      expect(session.position).toBe(0);
      expect(() => session.report).toThrow();
      await session.run({ faces: 100, runs: 20 });
      const result = await session.result();
      expect(result.model.faces).toEqual(model.faces);
      await session.inspect();
      expect((await session.result()).hash).toBe(result.hash);
    }));

  it('tells repairs as messages', () =>
    withThreads(1, async (pool) => {
      // The first face is given twice.
      const faces = [...cube.faces, cube.faces[0]!];
      const session = await opened(pool, objText({ ...cube, faces }));
      const { repairs } = await session.inspect();
      expect(repairs.map(({ code }) => code)).toContain('dropped-duplicate-faces');
      expect(repairs[0]!.params).toHaveProperty('count');
    }));

  it('tells bodies apart', () =>
    withThreads(1, async (pool) => {
      const text = together(movedCube(0, 1), movedCube(200, 0.01), movedCube(-200, 1));
      const { components, componentOfFaces } = await (await opened(pool, text)).inspect();
      expect(components.map(({ faces }) => faces)).toEqual([12, 12, 12]);
      expect(components[1]!.longestSide).toBeLessThan(0.02 * components[0]!.longestSide);
      expect(new Set(componentOfFaces)).toEqual(new Set([0, 1, 2]));
    }));

  it('rejects for files that are no models, and options that make no sense', () =>
    withThreads(1, async (pool) => {
      const broken = await opened(pool, 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n');
      await expect(broken.inspect()).rejects.toMatchObject({ code: 'bad-index' });
      const session = await opened(pool, objText(cube));
      await expect(session.inspect({ faces: 1 })).rejects.toThrow(/faces/);
      expect((await session.inspect()).model.faces).toHaveLength(36);
    }));

  it('ends at once when it is not needed any more', () =>
    withThreads(1, async (pool) => {
      const session = await opened(pool, objText(wavyRing(100)));
      const early = new Error('never wanted');
      const signal = AbortSignal.abort(early);
      await expect(session.inspect({}, { signal })).rejects.toBe(early);
      const abort = new AbortController();
      const look = session.inspect({ faces: 200 }, { signal: abort.signal });
      const late = new Error('not wanted any more');
      setTimeout(() => abort.abort(late), 20);
      await expect(look).rejects.toBe(late);
      expect((await session.inspect({ faces: 300 })).model.faces.length).toBeLessThanOrEqual(900);
    }));
});
