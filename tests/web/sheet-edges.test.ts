import { describe, expect, it } from 'vitest';
import type { DocumentEdit } from '../../web/model/document-edits.js';
import { edgeEdits, flapPlace, lockOf } from '../../web/model/edge-edits.js';
import { printedText, SheetEdges } from '../../web/model/sheet-edges.js';
import { addFlap } from './changed-result.js';
import { engineResult } from './engine-result.js';
import { boxAndLidResult, cubeResult, slitResult } from './fixtures.js';
import { objText, wavyRing } from './model-text.js';
import { isEngineBuilt } from './thread-pool.js';

type Gift = Extract<DocumentEdit, { kind: 'assign' }>;

const middle = ({ from, to }: { from: readonly number[]; to: readonly number[] }) =>
  [(from[0]! + to[0]!) / 2, (from[1]! + to[1]!) / 2] as const;

describe('edges on sheets', () => {
  it('are all but those inside of flat panels', () => {
    const { all } = new SheetEdges(cubeResult());
    expect(all.filter(({ kind }) => kind === 'mountain')).toHaveLength(5);
    expect(all.filter(({ kind }) => kind === 'cut')).toHaveLength(14);
    expect(all).toHaveLength(19);
  });

  it('lie where their piece lies', () => {
    const result = cubeResult();
    result.pieces[0] = { ...result.pieces[0]!, x: 20, y: 30 };
    const [moved, before] = [new SheetEdges(result), new SheetEdges(cubeResult())];
    moved.all.forEach(({ from, to }, i) => {
      const { from: start, to: end } = before.all[i]!;
      const { x, y } = cubeResult().pieces[0]!;
      expect([from[0] - 20, from[1] - 30]).toEqual([start[0] - x, start[1] - y]);
      expect([to[0] - 20, to[1] - 30]).toEqual([end[0] - x, end[1] - y]);
    });
  });

  it('have a partner if they are cut', () => {
    const edges = new SheetEdges(boxAndLidResult());
    for (const edge of edges.all) {
      const partner = edges.partnerOf(edge);
      expect(partner !== null).toBe(edge.kind === 'cut');
      if (!partner) continue;
      expect(edges.partnerOf(partner)).toBe(edge);
      expect(partner.name).toEqual([edge.name[1], edge.name[0]]);
      expect(partner.seam).toBe(edge.seam);
    }
  });

  it('end with the model at its borders', () => {
    const kinds = new SheetEdges(slitResult()).all.map(({ kind }) => kind);
    expect(kinds.filter((kind) => kind === 'border')).toHaveLength(4);
    expect(kinds.filter((kind) => kind === 'cut')).toHaveLength(2);
  });
});

describe('pointing at edges', () => {
  const edges = new SheetEdges(boxAndLidResult());

  it('finds the nearest within reach on its sheet', () => {
    for (const edge of edges.all) {
      const [x, y] = middle(edge);
      expect(edges.nearest(edge.sheet, [x + 0.5, y + 0.5], 3)).toBe(edge);
    }
    const [x, y] = middle(edges.all[0]!);
    expect(edges.nearest(7, [x, y], 3)).toBeNull();
  });

  it('leaves the inside of faces alone', () => {
    const { sheet, from } = edges.all.find(({ kind }) => kind === 'cut')!;
    expect(edges.nearest(sheet, [from[0] - 60, from[1] - 60], 3)).toBeNull();
    const { vertices, x, y, sheet: other } = edges.result.pieces[1]!;
    const centre = [0, 1].map((k) => {
      const values = [...vertices].filter((_, at) => at % 2 === k);
      return values.reduce((sum, value) => sum + value, 0) / values.length;
    });
    const inside = [x + centre[0]!, y + centre[1]!] as const;
    expect(edges.nearest(other, inside, 100)).toBeNull();
    // On a small picture a pixel is many millimetres.
    expect(edges.nearest(other, inside, 100, 25)).not.toBeNull();
  });

  it('finds them by what is printed, and by the names of lists', () => {
    for (const edge of edges.all.filter(({ seam }) => seam)) {
      expect(edges.numbered(` ${printedText(edge)!.toLowerCase()}`)).toContain(edge);
      const sides = edges.numbered(edge.seam!.name);
      expect(sides).toHaveLength(2);
      expect(sides).toContain(edge);
    }
    expect(edges.numbered('99')).toEqual([]);
    expect(edges.numbered('')).toEqual([]);
  });

  it('finds them by their vertices', () => {
    for (const edge of edges.all) expect(edges.find(edge.name)).toBe(edge);
    const fold = edges.all.find(({ kind }) => kind === 'mountain')!;
    expect(edges.find([fold.name[1], fold.name[0]])).toBe(fold);
    expect(edges.find([900, 901])).toBeNull();
  });
});

describe('what can be done at an edge', () => {
  it('is a cut at a fold, and nothing where the model ends', () => {
    const edges = new SheetEdges(slitResult());
    const border = edges.all.find(({ kind }) => kind === 'border')!;
    expect(edgeEdits(edges, border).size).toBe(0);
    const box = new SheetEdges(cubeResult());
    const fold = box.all.find(({ kind }) => kind === 'mountain')!;
    const lock = (as: string) => ({ kind: 'lock', edge: fold.name, as });
    expect([...edgeEdits(box, fold)]).toEqual([
      ['cut', { kind: 'cut', edge: fold.name }],
      ['lock-fold', lock('fold')],
      ['lock-cut', lock('cut')],
    ]);
  });

  it('hands the face at its side over to the part at the other side', () => {
    const edges = new SheetEdges(boxAndLidResult());
    const { pieces, model } = edges.result;
    const between = edges.all.filter(({ seam }) => seam && seam.pieces[0] !== seam.pieces[1]);
    for (const edge of between) {
      const gift = edgeEdits(edges, edge).get('give-face') as Gift;
      const other = pieces[edges.partnerOf(edge)!.piece]!;
      expect(gift).toMatchObject({ kind: 'assign', part: other.part + 1 });
      const [face] = gift.faces;
      expect(pieces[edge.piece]!.sources).toContain(face);
      const corners = model.faces.subarray(3 * face!, 3 * face! + 3);
      expect([...corners]).toEqual(expect.arrayContaining([...edge.name]));
      expect([...edgeEdits(edges, edge, 'cut').keys()]).not.toContain('give-face');
    }
    const within = edges.all.find(({ seam }) => seam && seam.pieces[0] === seam.pieces[1])!;
    expect([...edgeEdits(edges, within).keys()]).not.toContain('give-face');
  });

  it('is not what its lock forbids', () => {
    const edges = new SheetEdges(boxAndLidResult());
    const fold = edges.all.find(({ kind }) => kind === 'mountain')!;
    const cut = edges.all.find(({ kind }) => kind === 'cut')!;
    const [v, w] = fold.name;
    expect(lockOf(fold, [])).toBe('free');
    expect(lockOf(fold, [{ from: w, to: v, as: 'fold' }])).toBe('fold');
    expect([...edgeEdits(edges, fold, 'fold').keys()]).toEqual(['lock-cut', 'lock-free']);
    const actions = [...edgeEdits(edges, cut, 'cut').keys()];
    expect(actions).not.toContain('join');
    expect(actions).toEqual(expect.arrayContaining(['both-flaps', 'lock-fold', 'lock-free']));
    const free = { kind: 'lock', edge: cut.name, as: 'free' };
    expect(edgeEdits(edges, cut, 'cut').get('lock-free')).toEqual(free);
  });

  it('turns the flap away from where it is', () => {
    const result = boxAndLidResult();
    const seam = result.seams.findIndex(({ pieces: [a, b] }) => a !== b);
    addFlap(result, seam, 5);
    const edges = new SheetEdges(result);
    const [here, there] = edges.numbered(result.seams[seam]!.name);
    expect(flapPlace(edges, here!)).toBe('here');
    expect(flapPlace(edges, there!)).toBe('there');
    const turn = { kind: 'flap', edge: here!.name, side: 'second' };
    expect(edgeEdits(edges, here!).get('turn-flap')).toEqual(turn);
    expect(edgeEdits(edges, there!).get('turn-flap')).toMatchObject({ side: 'first' });
    expect([...edgeEdits(edges, here!).keys()]).not.toContain('cut');
  });

  it('has no flap to turn or to take away where there is none', () => {
    const edges = new SheetEdges(cubeResult());
    const cut = edges.all.find(({ kind }) => kind === 'cut')!;
    const flaps = [...edgeEdits(edges, cut).keys()].filter((action) => !action.includes('lock'));
    expect(flaps).toEqual(['join', 'both-flaps', 'usual-flap']);
  });
});

describe.skipIf(!isEngineBuilt)('edges of the engine', () => {
  it('have their piece on the left of their name, and flaps on one side', async () => {
    const result = await engineResult(objText(wavyRing(12)), { parts: 3 });
    const edges = new SheetEdges(result);
    const { faces } = result.model;
    const walks = new Map<string, number>();
    faces.forEach((from, at) => {
      const face = Math.floor(at / 3);
      walks.set(`${from} ${faces[3 * face + ((at + 1) % 3)]}`, face);
    });
    const cuts = edges.all.filter(({ kind }) => kind === 'cut');
    for (const { name, piece } of cuts) {
      expect(result.pieces[piece]!.sources).toContain(walks.get(name.join(' ')));
    }
    const { full, shrunk } = result.flaps;
    const sides = [...new Set(cuts.map(({ seam }) => seam!.name))].flatMap((name) =>
      edges.numbered(name),
    );
    expect(sides).toHaveLength(2 * result.seams.length);
    expect(sides.filter((side) => edges.hasFlap(side))).toHaveLength(full + shrunk);
  });
});
