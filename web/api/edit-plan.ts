/** What an edit asks of the engine. */
import type { DocumentEdit } from '../model/document-edits.js';
import { renamed, startFrom, startInPlace } from '../model/edits.js';
import type { EdgeName, JobStart, NetEdit, PartEdit, Piece } from '../model/job.js';
import type { EdgeLock, FlapChoice } from '../model/job-options.js';
import type { Message, MessageParams } from '../model/message.js';
import { isPinOf } from '../model/piece-edits.js';
import { BadOption } from '../words/bad-option.js';
import type { Code, Messages } from '../words/messages.js';
import { englishPhrase } from '../words/phrase.js';
import type { DocumentState, Wishes } from './document-state.js';
import { changedSettings, paperOptions, printOptionNames } from './written-options.js';

/** An edit that was made. */
export interface Applied {
  ok: true;
  /** Pieces that were not there before, counted from 1 in the order of gluing. */
  changed: number[];
}

/** Why an edit cannot be made; nothing was changed. */
export interface Refusal {
  ok: false;
  /** A stable word for programs. */
  code: string;
  /** What a sentence about it needs, and beside that: */
  params: MessageParams & {
    /** That sentence in English. */
    text: string;
    /** Faces of the repaired model that are in the way. */
    faces?: number[];
  };
}

/** A job that makes the next state, or none where only lines look different. */
export interface EditPlan {
  ok: true;
  wishes: Wishes;
  start: JobStart | null;
  /** Of this job alone. */
  seed?: number;
}

export function refusal<Name extends Code>(
  code: Name,
  params: Messages[Name] & MessageParams,
  faces?: Iterable<number>,
): Refusal {
  return refusalOf({ code, params }, faces);
}

/** The refusal that a message tells, of whatever code. */
export function refusalOf({ code, params }: Message, faces?: Iterable<number>): Refusal {
  const text = englishPhrase({ code, params });
  return { ok: false, code, params: { ...params, text, ...(faces && { faces: [...faces] }) } };
}

type PartChange = Extract<DocumentEdit, { kind: 'split' | 'merge' | 'again' }>;

/** Whether an edit makes parts of whole parts, so that several can be made in one go. */
function isPartChange(edit: DocumentEdit): edit is PartChange {
  return edit.kind === 'split' || edit.kind === 'merge' || edit.kind === 'again';
}

type FlapChange = Extract<DocumentEdit, { kind: 'flap' }>;

/** Whether an edit is about flaps alone, of which each goes its own way. */
function isFlapChange(edit: DocumentEdit): edit is FlapChange {
  return edit.kind === 'flap';
}

function partEditOf(edit: PartChange): PartEdit {
  if (edit.kind === 'split') return { parts: [edit.part - 1], into: edit.into };
  if (edit.kind === 'again') return { parts: [edit.part - 1], into: 1 };
  return { parts: edit.parts.map((part) => part - 1), into: 1 };
}

const flapSides = {
  first: 'left',
  second: 'right',
  both: 'both',
  none: 'none',
  auto: 'usual',
} as const;

function isSameEdge(choice: { from: number; to: number }, [v, w]: EdgeName): boolean {
  const { from, to } = choice;
  return (from === v && to === w) || (from === w && to === v);
}

function withFlap(
  choices: readonly FlapChoice[],
  { edge, side, height_mm }: FlapChange,
): FlapChoice[] {
  const others = choices.filter((choice) => !isSameEdge(choice, edge));
  if (side === 'auto' && height_mm === undefined) return others;
  const [from, to] = edge;
  const height = height_mm ?? choices.find((choice) => isSameEdge(choice, edge))?.height;
  return [...others, { from, to, flaps: flapSides[side], ...(height !== undefined && { height }) }];
}

function withLock(
  locks: readonly EdgeLock[],
  { edge, as }: Extract<DocumentEdit, { kind: 'lock' }>,
): EdgeLock[] {
  const others = locks.filter((lock) => !isSameEdge(lock, edge));
  return as === 'free' ? others : [...others, { from: edge[0], to: edge[1], as }];
}

/** The same start with room for so many sheets that there is this one, from 0. */
function withSheet(start: JobStart | null, sheet: number): JobStart | null {
  if (!start?.paper) return start;
  const sheets = Math.max(start.paper.sheets, sheet + 1);
  return { ...start, paper: { ...start.paper, sheets } };
}

/** Makes plans for one state. */
class Planner {
  constructor(private readonly state: DocumentState) {}

  /** A plan that keeps all pieces but those that it is about where they are. */
  private inPlace(wishes: Partial<Wishes>, parts: PartEdit[] = [], nets: NetEdit[] = []): EditPlan {
    const start = startInPlace(this.state.result, parts, nets);
    return { ok: true, wishes: { ...this.state.wishes, ...wishes }, start };
  }

  parts(edits: readonly PartChange[]): EditPlan {
    const plan = this.inPlace({}, edits.map(partEditOf));
    const again = edits.find((edit) => edit.kind === 'again');
    return again ? { ...plan, seed: again.seed } : plan;
  }

  flaps(edits: readonly FlapChange[]): EditPlan {
    return this.inPlace({ flapEdges: edits.reduce(withFlap, this.state.wishes.flapEdges) });
  }

  plan(edit: DocumentEdit): EditPlan | Refusal {
    const { wishes } = this.state;
    switch (edit.kind) {
      case 'split':
      case 'merge':
      case 'again':
        return this.parts([edit]);
      case 'assign':
        return this.inPlace({}, [], [{ ...edit, part: edit.part - 1 }]);
      case 'cut':
      case 'join':
        return this.inPlace({}, [], [edit]);
      case 'lock':
        return this.inPlace({ locks: withLock(wishes.locks, edit) }, [], [edit]);
      case 'flap':
        return this.flaps([edit]);
      case 'name':
        return this.name(edit.part, edit.text);
      case 'place':
      case 'unpin':
        return this.pin(edit);
      case 'paper':
        return this.paper(edit.options);
      case 'print':
        return this.print(edit.options);
    }
  }

  private name(part: number, text: string): EditPlan | Refusal {
    const { parts, names } = this.state.result;
    if (part > parts) return refusal('no-part', { part, parts });
    return this.inPlace({ names: renamed(names, part - 1, text) });
  }

  private pin(edit: Extract<DocumentEdit, { kind: 'place' | 'unpin' }>): EditPlan | Refusal {
    const piece: Piece | undefined = this.state.result.pieces[edit.piece - 1];
    const count = this.state.result.pieces.length;
    if (!piece) return refusal('no-piece', { piece: edit.piece, pieces: count });
    const { pins } = this.state.wishes;
    const others = pins.filter((pin) => !isPinOf(pin, piece));
    if (edit.kind === 'unpin') {
      if (others.length === pins.length) {
        return refusal('not-pinned', { piece: edit.piece });
      }
      return this.inPlace({ pins: others });
    }
    const { x_mm: x, y_mm: y, turn_deg: angle } = edit;
    const [part, face, sheet] = [piece.part, piece.sources[0]!, edit.sheet - 1];
    const plan = this.inPlace({ pins: [...others, { part, face, sheet, x, y, angle }] });
    // Who lays a piece on a sheet to come wants that sheet: all others stay where they are.
    return { ...plan, start: withSheet(plan.start, sheet) };
  }

  private paper(options: Readonly<Record<string, unknown>>): EditPlan {
    const { wishes, result } = this.state;
    const settings = changedSettings(wishes.settings, options, paperOptions);
    const next = { ...wishes, settings };
    // Numbers alone move nothing; all else lays the nets out anew.
    const isWords = Object.keys(options).every((name) => name === 'ids');
    return isWords
      ? this.inPlace({ settings })
      : { ok: true, wishes: next, start: startFrom(result, []) };
  }

  private print(options: Readonly<Record<string, unknown>>): EditPlan {
    const settings = changedSettings(this.state.wishes.settings, options, printOptionNames);
    return { ok: true, wishes: { ...this.state.wishes, settings }, start: null };
  }
}

/**
 * How a state becomes the next one. Several edits are made in one go if all are about flaps, or if all make parts of
 * whole parts, no part is named twice, and their numbers are those of this state.
 */
export function planEdits(
  state: DocumentState,
  edits: readonly DocumentEdit[],
): EditPlan | Refusal {
  const planner = new Planner(state);
  try {
    if (edits.length === 1) return planner.plan(edits[0]!);
    if (edits.every(isPartChange)) return planner.parts(edits);
    if (edits.every(isFlapChange)) return planner.flaps(edits);
  } catch (error) {
    if (!(error instanceof BadOption)) throw error;
    return refusal(error.code, error.params);
  }
  return refusal('not-together', {});
}

/** Pins and names as they are after a job, which may have given parts other numbers. */
export function settledWishes(wishes: Wishes, { result }: Pick<DocumentState, 'result'>): Wishes {
  const pieces = new Map(result.pieces.map((piece) => [piece.sources[0]!, piece]));
  const pins = wishes.pins.flatMap((pin) => {
    const piece = pieces.get(pin.face);
    if (!piece) return [];
    const { sheet, x, y } = piece;
    return [{ ...pin, part: result.labels[pin.face]!, sheet, x, y }];
  });
  return { ...wishes, names: result.names, pins };
}
