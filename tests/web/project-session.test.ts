/** Documents that are written as projects and opened again: the same bits, the same history. */
import { readFile } from 'node:fs/promises';
import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { makeDoor, type Door } from '../../web/api/door.js';
import type { RunWork } from '../../web/api/work.js';
import { finishedParts } from '../../web/app/result-words.js';
import type { Session } from '../../web/api/session.js';
import type { Pool } from '../../web/core/pool.js';
import type { TimedEvent } from '../../web/core/protocol.js';
import type { ModelFile } from '../../web/model/model-files.js';
import type { Project } from '../../web/project/project.js';
import { readProject } from '../../web/project/read-project.js';
import { writeProject } from '../../web/project/write-project.js';
import { objText, wavyRing } from './model-text.js';
import { readRenderer } from './printed.js';
import { projectErrors } from './project-schema.js';
import { Dice, randomEdit } from './random-edits.js';
import { isEngineBuilt, withThreads } from './thread-pool.js';

const model = { name: 'models/ring.obj', bytes: new TextEncoder().encode(objText(wavyRing(7))) };
const options = { parts: 4, height: 60, compact: 'off', runs: 20 } as const;

const fonts = new URL('../../dist/cli/fonts/', import.meta.url);
const readFont = async (name: string): Promise<Uint8Array> => readFile(new URL(name, fonts));

const doorOf = (pool: Pool): Door =>
  makeDoor({ startPool: () => pool, loadFont: readFont, loadRenderer: readRenderer });

async function projectOf(session: Session): Promise<ModelFile> {
  const [file] = await session.export('foldwright');
  expect(projectErrors(file!.bytes)).toEqual([]);
  return file!;
}

async function bytesOf(session: Session, format: 'pdf' | 'fold' | 'svg'): Promise<string[]> {
  const files = await session.export(format);
  return files.map(({ name, bytes }) => `${name} ${Buffer.from(bytes).toString('base64')}`);
}

async function hashOf(session: Session): Promise<string> {
  return (await session.result()).hash;
}

/** The hashes of all states, from the last one to the first. */
async function hashes(session: Session): Promise<string[]> {
  while (session.redo());
  const found = [await hashOf(session)];
  while (session.undo()) found.push(await hashOf(session));
  return found;
}

/** Stops work when it has told of a net and is in a stage. */
async function stopIn(
  stage: 'search' | 'paper',
  begin: (work: RunWork) => Promise<unknown>,
): Promise<void> {
  const control = new AbortController();
  let hasNet = false;
  const onEvent = (event: TimedEvent): void => {
    hasNet ||= event.type === 'net';
    const isThere = stage === 'search' || (event.type === 'stage' && event.stage === stage);
    if (hasNet && isThere) control.abort();
  };
  await begin({ stop: control.signal, onEvent });
  expect(control.signal.aborted).toBe(true);
}

/** A project with something changed in it. */
function changed({ name, bytes }: ModelFile, change: (project: Project) => Project): ModelFile {
  return { name, bytes: writeProject(change(readProject({ name, bytes }).project)) };
}

/** A project with a split, a name and another height of flaps, of which the last is undone. */
async function splitRing(door: Door): Promise<ModelFile> {
  const session = await door.open([model]);
  await session.run(options);
  await session.apply({ kind: 'split', part: 1, into: 2 });
  await session.apply({ kind: 'name', part: 2, text: 'Tail' });
  await session.apply({ kind: 'paper', options: { flaps: 3 } });
  session.undo();
  return projectOf(session);
}

describe.skipIf(!isEngineBuilt)('a project', () => {
  it('comes back with its history, and gives the same bytes in all formats', () =>
    withThreads(2, async (pool) => {
      const door = doorOf(pool);
      const session = await door.open([model]);
      await session.run(options);
      const dice = new Dice(20261129);
      while (session.position < 14) await session.apply(randomEdit(dice, await session.result()));
      session.undo();
      session.undo();
      const file = await projectOf(session);
      expect(file.name).toBe('ring.foldwright');
      const opened = await door.open([file]);
      expect([opened.title, opened.position, opened.canRedo]).toEqual(['ring', 12, true]);
      expect(opened.edits).toEqual(session.edits);
      expect(await hashOf(opened)).toBe(await hashOf(session));
      expect(opened.report).toEqual(session.report);
      for (const format of ['pdf', 'fold', 'svg'] as const) {
        expect(await bytesOf(opened, format)).toEqual(await bytesOf(session, format));
      }
      expect((await projectOf(opened)).bytes).toEqual(file.bytes);
      expect(await hashes(opened)).toEqual(await hashes(session));
    }));

  it('searches nothing again, and not at all before it is asked for its result', () =>
    withThreads(1, async (pool) => {
      const file = await splitRing(doorOf(pool));
      const opened = await doorOf(pool).open([file]);
      expect([opened.position, opened.canUndo, opened.canRedo]).toEqual([2, true, true]);
      expect(opened.nextStep).toEqual([{ kind: 'paper', options: { flaps: 3 } }]);
      expect(() => opened.report).toThrow('call result first');
      const events: TimedEvent[] = [];
      await opened.result({ onEvent: (event) => events.push(event) });
      expect(events.map(({ type }) => type)).toContain('done');
      expect(events.filter(({ type }) => type === 'generation' || type === 'learned')).toEqual([]);
      expect(opened.report.pieces.map(({ name }) => name)).toContain('Tail');
    }));

  it('goes on as the session that wrote it would have', () =>
    withThreads(1, async (pool) => {
      const door = doorOf(pool);
      const file = await splitRing(door);
      const [one, other] = [await door.open([file]), await door.open([file])];
      for (const session of [one, other]) {
        expect(await session.apply({ kind: 'split', part: 3, into: 2 })).toMatchObject({
          ok: true,
        });
        expect(session.canRedo).toBe(false);
      }
      expect(await hashOf(one)).toBe(await hashOf(other));
      // Back to the run, and from there once more.
      while (one.undo());
      expect((await one.result()).parts).toBe(4);
      await one.run({ ...options, seed: 2 });
      expect([one.position, one.canRedo]).toEqual([0, false]);
    }));

  it.each(['search', 'paper'] as const)(
    'of a run that was stopped in the stage %s has what was found until then, and says so',
    (stage) =>
      withThreads(1, async (pool) => {
        const door = doorOf(pool);
        const session = await door.open([model]);
        await stopIn(stage, (work) => session.run(options, work));
        const before = await session.result();
        const { notices } = before;
        expect(notices[0]).toEqual({ code: 'run-stopped', params: {} });
        const file = await projectOf(session);
        const opened = await door.open([file]);
        const events: TimedEvent[] = [];
        const after = await opened.result({ onEvent: (event) => events.push(event) });
        expect(after.hash).toBe(before.hash);
        expect(after.notices).toEqual(notices);
        expect(events.filter(({ type }) => type === 'generation' || type === 'learned')).toEqual(
          [],
        );
        expect((await projectOf(opened)).bytes).toEqual(file.bytes);
        // An edit looks for what is missing; the run itself goes on only when it is made again.
        expect(await opened.apply({ kind: 'name', part: 1, text: 'Tail' })).toMatchObject({
          ok: true,
        });
        const edited = await opened.result();
        expect(finishedParts(edited)).toBe(edited.parts);
        expect(edited.notices[0]).toEqual({ code: 'run-stopped', params: {} });
        opened.undo();
        expect(await hashOf(opened)).toBe(before.hash);
        await opened.run(options);
        expect(opened.report.notices.map(({ code }) => code)).not.toContain('run-stopped');
      }),
  );

  it('has what an edit had found when it was stopped', () =>
    withThreads(1, async (pool) => {
      const door = doorOf(pool);
      const session = await door.open([model]);
      await session.run(options);
      const edit = { kind: 'again', part: 1, seed: 5 } as const;
      await stopIn('search', (work) => session.apply(edit, work));
      const before = await session.result();
      expect(before.notices[0]).toEqual({ code: 'run-stopped', params: {} });
      const opened = await door.open([await projectOf(session)]);
      const after = await opened.result();
      expect([after.hash, after.notices]).toEqual([before.hash, before.notices]);
      expect(await hashes(opened)).toEqual(await hashes(session));
    }));

  it('makes all of it again where what was saved gives other bits', () =>
    withThreads(1, async (pool) => {
      const door = doorOf(pool);
      const file = await splitRing(door);
      const hash = await hashOf(await door.open([file]));
      const bare = changed(file, (project) => {
        return { ...project, states: project.states.map(() => null) };
      });
      // A net less: the engine would search another one.
      const wrong = changed(file, (project) => {
        const states = project.states.map((state) => {
          const { start } = state!;
          return { ...state!, start: { ...start, nets: start.nets.slice(1) } };
        });
        return { ...project, states };
      });
      const nonsense = changed(file, (project) => {
        const states = project.states.map((state) => {
          return { ...state!, start: { ...state!.start, labels: Int32Array.of(7) } };
        });
        return { ...project, states };
      });
      for (const one of [bare, wrong, nonsense]) {
        const session = await door.open([one]);
        expect(await hashOf(session)).toBe(hash);
        expect(session.report.notices.map(({ code }) => code)).not.toContain('project-redrawn');
      }
    }));

  it('of another version keeps its nets, and says so', () =>
    withThreads(1, async (pool) => {
      const door = doorOf(pool);
      const file = changed(await splitRing(door), (project) => {
        const states = project.states.map((state) => ({ ...state!, hash: '0'.repeat(16) }));
        return { ...project, app: '0.0.1', states };
      });
      const session = await door.open([file]);
      const { nets, notices } = await session.result();
      expect(notices[0]).toEqual({ code: 'project-redrawn', params: {} });
      const { states, cursor } = readProject(file).project;
      expect(nets.map(({ faces }) => faces)).toEqual(
        states[cursor]!.start.nets.map(({ faces }) => faces),
      );
      // What is told of a project does not go into the next one.
      const { project } = readProject(await projectOf(session));
      expect(JSON.stringify(project)).not.toContain('project-redrawn');
    }));

  it('ends before an edit that cannot be made any more, and says which settings it does not know', () =>
    withThreads(1, async (pool) => {
      const door = doorOf(pool);
      const file = changed(await splitRing(door), (project) => {
        const steps = [project.steps[0]!, [{ kind: 'name', part: 99, text: 'x' } as const]];
        const { options: own, states } = project;
        const [first, second] = states;
        const more = { ...own, glitter: 'on', margin: 'wide' };
        return { ...project, options: more, steps, states: [first!, second!, null], cursor: 2 };
      });
      const session = await door.open([file]);
      const { notices } = await session.result();
      expect(session.position).toBe(1);
      expect(session.canRedo).toBe(false);
      expect(notices.map(({ code, params }) => [code, params])).toEqual(
        expect.arrayContaining([
          ['project-options-lost', { options: ['margin', 'glitter'] }],
          ['project-damaged', { what: 'refused', count: 1 }],
        ]),
      );
    }));

  it('can be unfolded under other options, with its edits behind', () =>
    withThreads(1, async (pool) => {
      const { unfold } = doorOf(pool);
      const file = await splitRing(doorOf(pool));
      const same = await unfold([file], {}, { pool });
      expect(same.report.parts).toBe(5);
      const paper = await unfold([file], { paper: 'A5' }, { pool });
      expect([paper.report.parts, paper.result.sheets[0]!.width]).toEqual([5, 148]);
      const searched = await unfold([file], { seed: 5, parts: 3 }, { pool });
      expect(searched.report).toMatchObject({ seed: 5, parts: 4 });
      expect(searched.result.names.map(({ name }) => name)).toEqual(['Tail']);
      await expect(unfold([file], { parts: 1, seed: -3 }, { pool })).rejects.toThrow();
    }));

  it('is refused in one sentence where no model is left', () =>
    withThreads(1, async (pool) => {
      const broken = { name: 'a.foldwright', bytes: Uint8Array.of(1, 2, 3) };
      await expect(doorOf(pool).open([broken])).rejects.toMatchObject({
        name: 'JobError',
        code: 'bad-project',
        message: expect.stringContaining('is damaged') as string,
      });
    }));

  it('of the first version is read', () =>
    withThreads(1, async (pool) => {
      const path = new URL('../data/house.foldwright', import.meta.url);
      const file = { name: 'house.foldwright', bytes: new Uint8Array(readFileSync(path)) };
      expect(projectErrors(file.bytes)).toEqual([]);
      const session = await doorOf(pool).open([file]);
      expect(session.steps).toEqual([
        [{ kind: 'split', part: 1, into: 2 }],
        [{ kind: 'name', part: 1, text: 'Roof' }],
        [{ kind: 'paper', options: { flaps: 4 } }],
      ]);
      expect(session.position).toBe(2);
      const { names, nets, notices } = await session.result();
      expect(names).toEqual([{ part: 0, name: 'Roof' }]);
      // Whatever becomes of the engine: the nets are those of the file.
      const { states, cursor } = readProject(file).project;
      expect(nets.map(({ faces }) => faces)).toEqual(
        states[cursor]!.start.nets.map(({ faces }) => faces),
      );
      expect(notices.map(({ code }) => code)).not.toContain('project-damaged');
    }));
});
