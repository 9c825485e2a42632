import { describe, expect, it } from 'vitest';
import { edgeWords, giftWords, outcomeWords } from '../../web/app/edge-words.js';
import { editWords } from '../../web/app/edit-words.js';
import type { FlapChoiceSide, LockKind } from '../../web/model/document-edits.js';
import { SheetEdges, type SheetEdge } from '../../web/model/sheet-edges.js';
import { english } from '../../web/words/en/index.js';
import { boxAndLidResult, slitResult } from './fixtures.js';

const result = boxAndLidResult();
const edges = new SheetEdges(result);
const between = edges.all.find(({ seam }) => seam && seam.pieces[0] !== seam.pieces[1])!;
const within = edges.all.find(({ seam }) => seam && seam.pieces[0] === seam.pieces[1])!;
const fold = edges.all.find(({ kind }) => kind === 'mountain')!;
const number = between.seam!.texts[0];

describe('words for edges', () => {
  it('say what an edge is glued to, and where that lies', () => {
    const [, other] = between.seam!.texts;
    expect(edgeWords(english, edges, between)).toBe(`Edge ${number}: glued to ${other} on sheet 2`);
    const text = within.seam!.texts[0];
    expect(edgeWords(english, edges, within)).toBe(
      `Edge ${text}: glued to another edge of piece A`,
    );
  });

  it('say how a fold turns, and where the model ends', () => {
    expect(edgeWords(english, edges, fold)).toBe('Mountain fold of piece A, 90°');
    const open = new SheetEdges(slitResult());
    const border = open.all.find(({ kind }) => kind === 'border')!;
    expect(edgeWords(english, open, border)).toBe('Edge of piece A: the model ends here');
  });

  it('say what came of a change', () => {
    const before = { pieces: 3, flap: 'here', height: 5 } as const;
    const cut = { action: 'cut', before, after: { ...before, pieces: 4 } } as const;
    expect(outcomeWords(english, cut)).toBe('Cut. There are 4 pieces now; before there were 3.');
    const turned = { action: 'turn-flap', before, after: { ...before, flap: 'there' } } as const;
    expect(outcomeWords(english, turned)).toBe('');
    expect(
      outcomeWords(english, { ...turned, after: { ...before, flap: 'none', height: 0 } }),
    ).toBe('There is no room for a flap on that side.');
  });
});

describe('edits at edges in the history', () => {
  it('are named by the number of the edge, or by its piece', () => {
    const flap = (side: FlapChoiceSide) =>
      editWords(english, [{ kind: 'flap', edge: between.name, side }], result);
    expect(flap('second')).toBe(`flap of ${number} turned`);
    expect(flap('both')).toBe(`flaps on both sides of ${number}`);
    expect(flap('none')).toBe(`flap of ${number} taken away`);
    expect(editWords(english, [{ kind: 'cut', edge: fold.name }], result)).toBe('cut in A');
    expect(editWords(english, [{ kind: 'join', edge: fold.name }], result)).toBe('fold made in A');
  });

  it('say what is locked', () => {
    const lock = (as: LockKind, { name: edge }: SheetEdge) =>
      editWords(english, [{ kind: 'lock', edge, as }], result);
    expect(lock('fold', fold)).toBe('never cut in A');
    expect(lock('cut', between)).toBe(`always cut at ${number}`);
    expect(lock('free', fold)).toBe('lock taken away in A');
  });

  it('say what faces are given to', () => {
    expect(editWords(english, [{ kind: 'assign', faces: [1, 2], part: 2 }], result)).toBe(
      'faces given to part 2',
    );
    expect(giftWords(english, edges, between)).toBe('Give this face to B');
  });

  it('have words also for edges that are on no sheet', () => {
    expect(editWords(english, [{ kind: 'flap', edge: [900, 901], side: 'none' }], result)).toBe(
      'flap of an edge taken away',
    );
  });
});
