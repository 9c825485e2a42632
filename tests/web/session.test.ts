/** Documents: opened, edited step by step, undone, written; through workers. */
import { readFile } from 'node:fs/promises';
import { describe, expect, it } from 'vitest';
import { makeDoor } from '../../web/api/door.js';
import type { Applied } from '../../web/api/edit-plan.js';
import type { Session } from '../../web/api/session.js';
import type { Pool } from '../../web/core/pool.js';
import type { TimedEvent } from '../../web/core/protocol.js';
import type { Piece } from '../../web/model/job.js';
import type { DocumentEdit } from '../../web/model/document-edits.js';
import type { ModelFile } from '../../web/model/model-files.js';
import { SheetEdges } from '../../web/model/sheet-edges.js';
import { flapAt } from '../../web/model/sheet-flaps.js';
import { checkFold } from './fold-check.js';
import { parseFold } from './fold-file.js';
import { foldText } from './fold-text.js';
import { objText, wavyRing } from './model-text.js';
import { readRenderer } from './printed.js';
import { schemaErrors } from './report-schema.js';
import { isEngineBuilt, withThreads } from './thread-pool.js';

const bytes = new TextEncoder().encode(objText(wavyRing(10)));
const files = [{ name: 'models/ring.obj', bytes }];
const options = { parts: 4, height: 60, compact: 'off', runs: 40 } as const;

const fonts = new URL('../../dist/cli/fonts/', import.meta.url);
const readFont = async (file: string): Promise<Uint8Array> => readFile(new URL(file, fonts));

const door = (pool: Pool): ReturnType<typeof makeDoor> =>
  makeDoor({ startPool: () => pool, loadFont: readFont, loadRenderer: readRenderer });

async function withSession(
  work: (session: Session, pool: Pool) => Promise<void>,
  size = 2,
): Promise<void> {
  await withThreads(size, async (pool) => {
    const session = await door(pool).open(files, { pool });
    await session.run(options);
    await work(session, pool);
  });
}

async function made(session: Session, edit: DocumentEdit): Promise<Applied> {
  const applied = await session.apply(edit);
  if (!applied.ok) throw new Error(`${edit.kind}: ${applied.code} ${applied.params.text}`);
  return applied;
}

/** The first fold of the piece with most, as vertices of the model. */
async function someFold(session: Session): Promise<[number, number]> {
  const { top, nets } = parseFoldOf(await foldText(session));
  const largest = Math.max(...nets.map(({ edges_vertices }) => edges_vertices.length));
  const net = nets.find(({ edges_vertices }) => edges_vertices.length === largest)!;
  const sources = net['faces_foldwright:source'];
  for (const [e, [v, w]] of net.edges_vertices.entries()) {
    if (!'MV'.includes(net.edges_assignment[e]!)) continue;
    for (const [f, face] of net.faces_vertices.entries()) {
      const [i, j] = [face.indexOf(v!), face.indexOf(w!)];
      if (i < 0 || j < 0) continue;
      const corners = top[sources[f]!]!;
      return [corners[i]!, corners[j]!];
    }
  }
  throw new Error('There is no fold');
}

function parseFoldOf(text: string): {
  top: number[][];
  nets: ReturnType<typeof parseFold>['nets'];
} {
  const { model, nets } = parseFold(text);
  return { top: model.faces_vertices, nets };
}

describe.skipIf(!isEngineBuilt)('several files', () => {
  const materials = { name: 'ring.mtl', bytes: new TextEncoder().encode('newmtl wood') };
  const notes = { name: 'notes.obj', bytes: new TextEncoder().encode('Dear Sir or Madam') };
  const figure = { name: 'models/figure.txt', bytes };

  it('are one model and its companions, by their contents', () =>
    withThreads(1, async (pool) => {
      const session = await door(pool).open([materials, notes, figure], { pool });
      expect(session.title).toBe('notes');
      const report = await session.run(options);
      expect(session.title).toBe('figure');
      expect((await session.result()).file).toBe('models/figure.txt');
      const [ignored] = report.notices.filter(({ code }) => code === 'files-ignored');
      expect(ignored?.text).toContain('ring.mtl and notes.obj');
      const alone = await door(pool).unfold(files, options, { pool });
      expect(report.result_hash).toBe(alone.report.result_hash);
      // Nothing was taken away: the same files can be run again.
      expect(figure.bytes.length).toBe(bytes.length);
    }));

  it('are refused unless there is one model among them', () =>
    withThreads(1, async (pool) => {
      const run = (given: readonly ModelFile[]) => door(pool).unfold(given, options, { pool });
      await expect(run([...files, figure])).rejects.toMatchObject({
        code: 'several-models',
        message: expect.stringContaining("'models/ring.obj' and 'models/figure.txt'") as string,
      });
      await expect(run([materials, { ...materials, name: 'b.mtl' }])).rejects.toMatchObject({
        code: 'no-model',
      });
      await expect(run([])).rejects.toThrow('There is no file to open');
    }));
});

describe.skipIf(!isEngineBuilt)('a session', () => {
  it('unfolds, and writes every format', () =>
    withThreads(2, async (pool) => {
      const unfolded = await door(pool).unfold(files, options, { pool });
      expect(schemaErrors(unfolded.report)).toEqual([]);
      expect(unfolded.report.parts).toBe(4);
      expect(unfolded.report.options).toMatchObject({ parts: 4, paper: 'A4' });
      const starts = { fold: '{', svg: '<', pdf: '%PDF', glb: 'glTF' } as const;
      for (const format of ['fold', 'svg', 'pdf', 'glb'] as const) {
        const [file] = await unfolded.export(format);
        expect(file!.name).toMatch(new RegExp(`^ring(-1)?\\.${format}$`));
        expect(new TextDecoder().decode(file!.bytes.subarray(0, 4))).toContain(starts[format]);
      }
      const large = await unfolded.export('svg', { paper: 'A2' });
      expect(large).toHaveLength(1);
      expect(new TextDecoder().decode(large[0]!.bytes)).toContain('width="420mm"');
    }));

  it('cuts and joins, and leaves other pieces where they are', () =>
    withSession(async (session) => {
      const before = await session.result();
      const edge = await someFold(session);
      const { changed } = await made(session, { kind: 'cut', edge });
      expect(changed).toHaveLength(2);
      const after = await session.result();
      expect(after.pieces).toHaveLength(before.pieces.length + 1);
      const places = new Set(
        before.pieces.map(({ sheet, x, y }) => `${sheet} ${x.toFixed(6)} ${y.toFixed(6)}`),
      );
      const moved = after.pieces.filter(
        ({ sheet, x, y }) => !places.has(`${sheet} ${x.toFixed(6)} ${y.toFixed(6)}`),
      );
      expect(moved.length).toBeLessThanOrEqual(2);
      await made(session, { kind: 'join', edge });
      expect(session.report.pieces).toHaveLength(before.pieces.length);
      expect(session.edits).toHaveLength(2);
    }));

  it('gives the same bytes again after undo and redo', () =>
    withSession(async (session) => {
      const first = await foldText(session);
      await made(session, { kind: 'split', part: 1, into: 2 });
      await made(session, { kind: 'name', part: 2, text: 'Crest' });
      const last = await foldText(session);
      expect(session.undo()).toBe(true);
      expect(session.undo()).toBe(true);
      expect(session.undo()).toBe(false);
      expect(session.report.parts).toBe(4);
      expect(await foldText(session)).toBe(first);
      expect([session.redo(), session.redo(), session.redo()]).toEqual([true, true, false]);
      expect(await foldText(session)).toBe(last);
      // Another edit takes the place of what was undone.
      session.undo();
      await made(session, { kind: 'print', options: { style: 'pepakura' } });
      expect(session.canRedo).toBe(false);
      expect(session.edits.map(({ kind }) => kind)).toEqual(['split', 'print']);
    }));

  it('keeps edges as they are locked', () =>
    withSession(async (session) => {
      const edge = await someFold(session);
      await made(session, { kind: 'lock', edge, as: 'fold' });
      const refused = await session.apply({ kind: 'cut', edge });
      expect(refused).toMatchObject({ ok: false, code: 'locked' });
      for (let part = 1; part <= 4; ++part) {
        await made(session, { kind: 'again', part, seed: 5 + part });
      }
      // It is a fold still: it cannot be joined.
      const joined = await session.apply({ kind: 'join', edge });
      expect(joined).toMatchObject({ ok: false, code: 'already-joined' });
      await made(session, { kind: 'lock', edge, as: 'cut' });
      expect(await session.apply({ kind: 'cut', edge })).toMatchObject({ code: 'locked' });
      expect(await session.apply({ kind: 'join', edge })).toMatchObject({ code: 'locked' });
      await made(session, { kind: 'lock', edge, as: 'free' });
      expect(await session.apply({ kind: 'cut', edge })).toMatchObject({ code: 'already-cut' });
      expect(checkFold(parseFold(await foldText(session)))).toEqual([]);
    }));

  it('refuses what cannot be done by a code, and changes nothing', () =>
    withSession(async (session) => {
      const before = await foldText(session);
      const edge = await someFold(session);
      const refused: [DocumentEdit, string][] = [
        [{ kind: 'cut', edge: [0, 0] }, 'no-edge'],
        [{ kind: 'join', edge }, 'already-joined'],
        [{ kind: 'split', part: 9, into: 2 }, 'bad-edit'],
        [{ kind: 'name', part: 9, text: 'x' }, 'no-part'],
        [{ kind: 'name', part: 1, text: 'a:b' }, 'bad-option'],
        [{ kind: 'unpin', piece: 1 }, 'not-pinned'],
        [{ kind: 'place', piece: 99, sheet: 1, x_mm: 0, y_mm: 0, turn_deg: 0 }, 'no-piece'],
        [{ kind: 'place', piece: 1, sheet: 1, x_mm: -50, y_mm: 0, turn_deg: 0 }, 'bad-pin'],
        [{ kind: 'paper', options: { parts: 3 } }, 'bad-option'],
        [{ kind: 'paper', options: { paper: 'A9' } }, 'bad-option'],
        [{ kind: 'print', options: { colour: 'stripes' } }, 'bad-option'],
        [{ kind: 'assign', faces: [1e6], part: 1 }, 'no-face'],
        [{ kind: 'flap', edge: [0, 0], side: 'both' }, 'bad-option'],
        [{ kind: 'flap', edge, side: 'auto', height_mm: 0.5 }, 'bad-option'],
      ];
      for (const [edit, code] of refused) {
        expect(await session.apply(edit), JSON.stringify(edit)).toMatchObject({ ok: false, code });
      }
      expect(session.edits).toEqual([]);
      expect(await foldText(session)).toBe(before);
    }));

  it('keeps a pinned piece through other edits until it is let go', () =>
    withSession(async (session) => {
      const { sheet, x, y, angle } = (await session.result()).pieces[0]!;
      const place = { sheet: sheet + 1, x_mm: x, y_mm: y, turn_deg: angle };
      await made(session, { kind: 'place', piece: 1, ...place });
      await made(session, { kind: 'paper', options: { paper: 'A3' } });
      const piece = (await session.result()).pieces[0]!;
      expect([piece.x, piece.y]).toEqual([expect.closeTo(x, 6), expect.closeTo(y, 6)]);
      await made(session, { kind: 'unpin', piece: 1 });
      expect(await session.apply({ kind: 'unpin', piece: 1 })).toMatchObject({ ok: false });
    }));

  it('keeps the height of a flap that changes sides, until it is to be as usual again', () =>
    withSession(async (session) => {
      const before = new SheetEdges(await session.result());
      const edge = before.all.find((one) => one.kind === 'cut' && before.hasFlap(one))!;
      const height = async (): Promise<number> => {
        const edges = new SheetEdges(await session.result());
        return flapAt(edges, edges.find(edge.name)!)!.height;
      };
      const usual = await height();
      await made(session, { kind: 'flap', edge: edge.name, side: 'first', height_mm: 2 });
      expect(await height()).toBeCloseTo(2);
      await made(session, { kind: 'flap', edge: edge.name, side: 'second' });
      expect(await height()).toBeCloseTo(2);
      await made(session, { kind: 'flap', edge: edge.name, side: 'auto' });
      expect(await height()).toBeCloseTo(usual);
    }));

  it('loses nothing when its workers end in the middle of an edit', () =>
    withSession(async (session, pool) => {
      await made(session, { kind: 'split', part: 1, into: 2 });
      const before = await foldText(session);
      const dying = session.apply({ kind: 'split', part: 2, into: 2 });
      setTimeout(() => pool.close(), 20);
      await expect(dying).rejects.toThrow('stopped unexpectedly');
      expect(await foldText(session)).toBe(before);
      await made(session, { kind: 'split', part: 2, into: 2 });
      expect(session.edits).toHaveLength(2);
    }));

  it('says what is wrong with a value that is no edit, and works on', () =>
    withSession(async (session) => {
      const nothing = { kind: 'name', part: 1 } as unknown as DocumentEdit;
      await expect(session.apply(nothing)).rejects.toThrow('text');
      expect(session.edits).toEqual([]);
      await made(session, { kind: 'name', part: 1, text: 'Ear' });
    }));

  it('can be cancelled', () =>
    withSession(async (session) => {
      const signal = AbortSignal.timeout(5);
      const edit = { kind: 'split', part: 1, into: 3 } as const;
      await expect(session.apply(edit, { signal })).rejects.toThrow();
      expect(session.edits).toEqual([]);
      await made(session, edit);
    }));

  it('keeps the nets of a run that is stopped, and goes on from them', () =>
    withThreads(1, async (pool) => {
      const session = await door(pool).open(files, { pool: () => pool });
      const abort = new AbortController();
      const onEvent = ({ type }: TimedEvent): void => {
        if (type === 'net') abort.abort();
      };
      const { signal } = abort;
      const ended = session.run(options, { signal, onEvent });
      await expect(ended).rejects.toThrow();
      expect(() => session.report).toThrow('Nothing was unfolded');

      const second = new AbortController();
      // A net of the search may be given up again for other borders of its part; these stay.
      const end = (event: TimedEvent): void => {
        if (event.type === 'stage' && event.stage === 'paper') second.abort();
      };
      await session.run(options, { stop: second.signal, onEvent: end });
      const found = await session.result();
      expect(found.parts).toBe(4);
      expect(found.pieces.length).toBeGreaterThan(0);
      const some = found.pieces[0]!.part + 1;
      await made(session, { kind: 'split', part: some, into: 2 });
      expect((await session.result()).parts).toBe(5);
      expect(session.lastStep).toEqual([{ kind: 'split', part: some, into: 2 }]);
      session.undo();
      expect([session.position, session.lastStep]).toEqual([0, null]);
      expect(session.nextStep).toHaveLength(1);
      expect((await session.state()).result).toBe(found);
    }));

  it('keeps what there is of an edit that is stopped, as a state like any other', () =>
    withThreads(1, async (pool) => {
      const session = await door(pool).open(files, { pool: () => pool });
      await session.run(options);
      const whole = await session.result();
      const control = new AbortController();
      // The parts that the edit leaves alone are told of first; the other one may be found meanwhile.
      const heard = new Set<string>();
      const onEvent = ({ type }: TimedEvent): void => {
        heard.add(type);
        if (type === 'net') control.abort();
      };
      const edit = { kind: 'again', part: 1, seed: 5 } as const;
      const applied = await session.apply(edit, { stop: control.signal, onEvent });
      expect(applied).toMatchObject({ ok: true });
      const found = await session.result();
      const others = whole.pieces.filter(({ part }) => part !== 0);
      expect(heard.has('cancelled') && !heard.has('done')).toBe(true);
      const kept = (pieces: Piece[]): string[] => pieces.map(({ sources }) => sources.join());
      expect(kept(found.pieces)).toEqual(expect.arrayContaining(kept(others)));
      expect([session.position, session.lastStep]).toEqual([1, [edit]]);
      session.undo();
      expect(await session.result()).toBe(whole);
      session.redo();
      expect(await session.result()).toBe(found);
    }));

  it('asks for workers only when there is work for them', async () => {
    const { open } = makeDoor({
      startPool: () => null as never,
      loadFont: readFont,
      loadRenderer: readRenderer,
    });
    let asked = 0;
    const session = await open(files, {
      pool: () => {
        ++asked;
        throw new Error('no workers');
      },
    });
    expect(asked).toBe(0);
    await expect(session.run(options)).rejects.toThrow('no workers');
    expect(asked).toBe(1);
    session.close();
  });

  it('refuses options that there are not', () =>
    withThreads(1, async (pool) => {
      const { unfold } = door(pool);
      const attempt = (asked: object): Promise<unknown> => unfold(files, asked, { pool });
      await expect(attempt({ parts: 0 })).rejects.toThrow("option 'parts': '0'");
      await expect(attempt({ partz: 1 })).rejects.toThrow("no option 'partz'");
      await expect(attempt({ height: 10, width: 10 })).rejects.toThrow('given by');
      await expect(attempt({ margin: 200 })).rejects.toThrow('leave nothing');
    }));
});
