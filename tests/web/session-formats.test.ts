/** Models that go through a reader before the engine: once, under their own names. */
import { describe, expect, it } from 'vitest';
import { Session } from '../../web/api/session.js';
import type { Pool } from '../../web/core/pool.js';
import type { TimedEvent } from '../../web/core/protocol.js';
import type { ModelFile } from '../../web/model/model-files.js';
import { Scene } from './gltf-files.js';
import { box, objOf } from './solids.js';
import { isEngineBuilt, withThreads } from './thread-pool.js';
import { meshObject, modelPart, threeMf, zip } from './zips.js';

const options = { runs: 20, seed: 1, folding: 'off' } as const;

function sessionOf(pool: Pool, ...files: ModelFile[]): Session {
  const none = (): Promise<Uint8Array> => Promise.reject(new Error('not needed here'));
  return new Session(files, { pool: () => pool, loadFont: none, loadRenderer: none });
}

async function glb(name: string): Promise<ModelFile> {
  const scene = new Scene();
  scene.add(box(1, 2, 3));
  scene.document.createAnimation();
  return { name, bytes: await scene.glb() };
}

describe.skipIf(!isEngineBuilt)('a session with a file that must be read first', () => {
  it('tells its own name and what is not used, in events, result and report', () =>
    withThreads(1, async (pool) => {
      const session = sessionOf(pool, await glb('models/box.v2.glb'));
      const events: TimedEvent[] = [];
      const report = await session.run(
        { ...options, scale: 0.05 },
        { onEvent: (e) => events.push(e) },
      );
      const result = await session.result();
      expect([result.file, session.title]).toEqual(['models/box.v2.glb', 'box.v2']);
      expect(events).toContainEqual(expect.objectContaining({ type: 'model', file: result.file }));
      const done = events.find((event) => event.type === 'done');
      expect(done).toMatchObject({ result: { file: result.file, notices: result.notices } });
      expect(report.notices.map(({ code }) => code)).toContain('unused-content');
      expect(result.repairs.map(({ code }) => code)).not.toContain('other-format');
      // glTF is in metres.
      expect(report.size_mm).toEqual([50, 100, 150]);
      expect(report.notices.map(({ code }) => code)).not.toContain('unit-guessed');
    }));

  it('reads it once for all edits, and gives the same bits each time', () =>
    withThreads(1, async (pool) => {
      const run = async (): Promise<string[]> => {
        const session = sessionOf(pool, await glb('box.glb'));
        await session.run({ ...options, parts: 1 });
        const first = (await session.result()).hash;
        expect(await session.apply({ kind: 'split', part: 1, into: 2 })).toMatchObject({
          ok: true,
        });
        const { hash, file, notices } = await session.result();
        expect(file).toBe('box.glb');
        expect(notices.filter(({ code }) => code === 'unused-content')).toHaveLength(1);
        return [first, hash];
      };
      expect(await run()).toEqual(await run());
    }));

  it('turns 3MF, whose z points up, and an archive gives what its model gives', () =>
    withThreads(1, async (pool) => {
      const model = modelPart(meshObject(1, box(10, 20, 30)), '<item objectid="1"/>');
      const report = await sessionOf(pool, threeMf(model)).run({ ...options, scale: 1 });
      expect(report.size_mm).toEqual([10, 30, 20]);
      expect(report.notices.map(({ code }) => code)).not.toContain('up-guessed');
      const obj = { name: 'deep/a.obj', bytes: new TextEncoder().encode(objOf(box(1, 2, 3))) };
      const [alone, packed] = [obj, zip('a.zip', { [obj.name]: obj.bytes })].map((file) =>
        sessionOf(pool, file),
      ) as [Session, Session];
      expect((await packed.run(options)).result_hash).toBe((await alone.run(options)).result_hash);
      expect(packed.title).toBe('a');
    }));

  it('rejects with a sentence, and works on after it was ended while reading', () =>
    withThreads(1, async (pool) => {
      const broken = sessionOf(pool, zip('a.zip', {}));
      await expect(broken.run(options)).rejects.toMatchObject({
        code: 'no-model-in-archive',
        message: "there is nothing in the archive 'a.zip'",
      });
      const session = sessionOf(pool, await glb('box.glb'));
      const abort = new AbortController();
      const ended = session.run(options, { signal: abort.signal });
      setTimeout(() => abort.abort(new Error('enough')), 1);
      await expect(ended).rejects.toThrow('enough');
      expect((await session.run(options)).model.faces).toBe(12);
    }));
});
