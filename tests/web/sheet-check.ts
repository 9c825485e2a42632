/**
 * Judges written sheets as someone with scissors would, against the FOLD file of the same run: the
 * latter's own check ties it to the model.
 */
import type { FoldFile, NetFrame } from './fold-file.js';
import { pieceLines, type CutSide, type Lines } from './sheet-lines.js';
import type { PieceLines, Point, SheetFile, SheetText } from './sheet-file.js';

// What the files' decimals and the printer leave open, in mm.
const tolerance = 0.01;

const cross = (a: Point, b: Point, c: Point): number =>
  (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
const distance = (a: Point, b: Point): number => Math.hypot(a[0] - b[0], a[1] - b[1]);

/** Whether two segments pass through each other by more than the tolerance. */
function cutThrough([a, b]: [Point, Point], [c, d]: [Point, Point]): boolean {
  const [long, other] = [distance(a, b), distance(c, d)];
  if (long < tolerance || other < tolerance) return false;
  const [s, t] = [cross(a, b, c) / long, cross(a, b, d) / long];
  const [u, v] = [cross(c, d, a) / other, cross(c, d, b) / other];
  const apart = (x: number, y: number): boolean =>
    Math.min(x, y) < -tolerance && Math.max(x, y) > tolerance;
  return apart(s, t) && apart(u, v);
}

function sidesOf(walk: Point[]): [Point, Point][] {
  return walk.map((point, i) => [point, walk[(i + 1) % walk.length]!]);
}

function isInside([x, y]: Point, walks: Point[][]): boolean {
  let inside = false;
  for (const [[ax, ay], [bx, by]] of walks.flatMap(sidesOf)) {
    if (ay > y !== by > y && x < ax + ((y - ay) / (by - ay)) * (bx - ax)) inside = !inside;
  }
  return inside;
}

function* pairs<Item>(items: readonly Item[]): Generator<[Item, Item]> {
  for (let i = 0; i < items.length; ++i) {
    for (let j = 0; j < i; ++j) yield [items[i]!, items[j]!];
  }
}

/** The ink of a text, with figures as wide as Helvetica's. */
function inkOf({ text, at, angle, size }: SheetText): Point[] {
  const turn = (angle * Math.PI) / 180;
  const half = 0.27 * size * text.replaceAll(':', '').length;
  const on = (along: number, up: number): Point => [
    at[0] + along * Math.cos(turn) - up * Math.sin(turn),
    at[1] + along * Math.sin(turn) + up * Math.cos(turn),
  ];
  return [on(-half, 0), on(half, 0), on(half, 0.7 * size), on(-half, 0.7 * size)];
}

/** Cuts: closed walks within the margins that cross neither themselves nor those of other pieces. */
function checkCuts(sheet: SheetFile, margin: number): string[] {
  const faults: string[] = [];
  const sides: { letter: string; side: [Point, Point] }[] = [];
  const all: [string, PieceLines][] = [
    ...sheet.pieces,
    ...[...sheet.strips].map(([id, lines]): [string, PieceLines] => [`strip ${id}`, lines]),
  ];
  for (const [letter, { cuts }] of all) {
    for (const walk of cuts) {
      for (const side of sidesOf(walk)) sides.push({ letter, side });
      for (const [x, y] of walk) {
        const least = Math.min(x, y, sheet.width - x, sheet.height - y);
        if (least < margin - tolerance) faults.push(`${letter}: in the margin at ${x} ${y}`);
      }
    }
  }
  for (const [a, b] of pairs(sides)) {
    if (cutThrough(a.side, b.side)) faults.push(`${a.letter} runs into ${b.letter}`);
  }
  for (const [[a, first], [b, second]] of pairs(all)) {
    const apart =
      !isInside(first.cuts[0]![0]!, second.cuts) && !isInside(second.cuts[0]![0]!, first.cuts);
    if (!apart) faults.push(`${a} and ${b} lie on each other`);
  }
  return faults;
}

/** Whether figures are another number when the paper is turned, written down by hand. */
function isMisread(text: string): boolean {
  const turned = [...text].reverse().map((figure) => '01xxxx9x86'[Number(figure)] ?? 'x');
  return /^\d+$/.test(text) && /^[^0x][^x]*$/.test(turned.join('')) && turned.join('') !== text;
}

/** Whether a line runs below a text, along it, by at most a fifth of its size. */
function isBelow([from, to]: [Point, Point], { at, angle, size }: SheetText): boolean {
  const turn = (angle * Math.PI) / 180;
  const middle: Point = [(from[0] + to[0]) / 2 - at[0], (from[1] + to[1]) / 2 - at[1]];
  const along = middle[0] * Math.cos(turn) + middle[1] * Math.sin(turn);
  const up = middle[1] * Math.cos(turn) - middle[0] * Math.sin(turn);
  const slope = Math.atan2(to[1] - from[1], to[0] - from[0]) - turn;
  return up < 0 && up > -size / 5 && Math.abs(along) < size / 5 && Math.abs(Math.sin(slope)) < 0.01;
}

/** Numbers that are others upside down have a line below them that nothing runs through; no others have. */
function checkUnderlines(
  letter: string,
  { cuts, guides, mountains, texts, underlines, valleys }: PieceLines,
): string[] {
  const lines = [...cuts.flatMap(sidesOf), ...mountains, ...valleys, ...guides];
  const faults = texts.flatMap((text) => {
    const below = underlines.filter((underline) => isBelow(underline, text)).length;
    return below === (isMisread(text.text) ? 1 : 0)
      ? []
      : [`${letter}: ${below} lines below ${text.text}`];
  });
  if (underlines.length !== texts.filter(({ text }) => isMisread(text)).length) {
    faults.push(`${letter}: a line is below no number`);
  }
  const isMet = underlines.some((one) => lines.some((line) => cutThrough(line, one)));
  return isMet ? [...faults, `${letter}: a line runs through one below a number`] : faults;
}

function checkTexts(letter: string, drawn: PieceLines): string[] {
  const { cuts, mountains, valleys, guides, texts } = drawn;
  const faults = checkUnderlines(letter, drawn);
  const lines = [...cuts.flatMap(sidesOf), ...mountains, ...valleys, ...guides];
  for (const text of texts) {
    const ink = inkOf(text);
    if (text.angle <= -90.001 || text.angle > 90.001)
      faults.push(`${letter}: ${text.text} stands on its head`);
    const sides = sidesOf(ink);
    if (lines.some((line) => sides.some((side) => cutThrough(line, side)))) {
      faults.push(`${letter}: a line runs through ${text.text}`);
    }
    if (!ink.every((corner) => isInside(corner, cuts))) {
      faults.push(`${letter}: ${text.text} is not on the piece`);
    }
  }
  for (const [a, b] of pairs(texts)) {
    const meet = sidesOf(inkOf(a)).some((s) => sidesOf(inkOf(b)).some((t) => cutThrough(s, t)));
    if (meet) faults.push(`${letter}: ${a.text} is written over ${b.text}`);
  }
  return faults;
}

/** Guides lie on the paper of their piece. */
function checkGuides(letter: string, { cuts, guides }: PieceLines): string[] {
  const outline = cuts.flatMap(sidesOf);
  const stays = (guide: [Point, Point]): boolean =>
    guide.every((end) => isInside(end, cuts)) && !outline.some((side) => cutThrough(side, guide));
  return guides.every(stays) ? [] : [`${letter}: a guide leaves the paper`];
}

/** Strips are folded once, by an edge's full length and sign, and hidden behind 4 mm of each face. */
function checkStrip(id: string, strip: PieceLines, sides: CutSide[]): string[] {
  const faults = checkTexts(`strip ${id}`, strip);
  const folds = [...strip.mountains, ...strip.valleys];
  const [[from, to] = [[0, 0] as Point, [0, 0] as Point]] = folds;
  if (folds.length !== 1 || strip.cuts.length !== 1) return [`strip ${id} is not one strip`];
  const sign = strip.valleys.length > 0 ? 1 : -1;
  const isEdge = (side: CutSide): boolean =>
    Math.abs(distance(side.from, side.to) - distance(from, to)) < tolerance &&
    (side.angle > 0 ? 1 : -1) === sign;
  if (!sides.some(isEdge)) faults.push(`strip ${id} is as long as no edge`);
  const away = strip.cuts[0]!.map((point) => Math.abs(cross(from, to, point)) / distance(from, to));
  if (Math.max(...away) > 4 + tolerance) faults.push(`strip ${id} is too wide`);
  if (!strip.texts.some(({ text }) => text === id)) faults.push(`strip ${id} has no number`);
  return faults;
}

/**
 * Whether the walks go along an edge, straight or around a flap on its outer side. Corners of a wedge
 * may be closer than the tolerance: straight lines are looked for first, or such an edge would be
 * taken for a flap of the one beside it.
 */
function findCut(walks: Point[][], from: Point, to: Point): 'straight' | Point[] | null {
  let around: Point[] | null = null;
  for (const walk of walks) {
    for (let i = 0; i < walk.length; ++i) {
      if (distance(walk[i]!, from) > tolerance) continue;
      // Around a flap five points are enough, and along an edge one.
      const ahead = [1, 2, 3, 4, 5].map((step) => walk[(i + step) % walk.length]!);
      const end = ahead.findIndex((point) => distance(point, to) <= tolerance);
      if (end === 0) return 'straight';
      const between = ahead.slice(0, Math.max(end, 0));
      // A slit that does not open leads away and back: the way round the edge begins after it.
      const comesBack = between.some((point) => distance(point, from) <= tolerance);
      if (end > 0 && !comesBack && between.every((point) => cross(from, to, point) < tolerance)) {
        around ??= [from, ...between, ahead[end]!];
      }
    }
  }
  return around;
}

function takeFold(folds: [Point, Point][], from: Point, to: Point): boolean {
  const at = folds.findIndex(
    ([a, b]) =>
      (distance(a, from) <= tolerance && distance(b, to) <= tolerance) ||
      (distance(a, to) <= tolerance && distance(b, from) <= tolerance),
  );
  if (at >= 0) folds.splice(at, 1);
  return at >= 0;
}

/** Whether a point lies within one of the triangles, or as near as the tolerance. */
function isOver(triangles: Point[][], point: Point): boolean {
  return triangles.some((corners) => {
    const turns = sidesOf(corners).map(([a, b]) => cross(a, b, point) / distance(a, b));
    return turns.every((turn) => turn > -tolerance) || turns.every((turn) => turn < tolerance);
  });
}

/** Every edge of the net is drawn as what it is, and nothing else is. */
function checkEdges(letter: string, frame: NetFrame, lines: PieceLines, net: Lines): string[] {
  const faults: string[] = [];
  const left = { M: [...lines.mountains], V: [...lines.valleys] };
  frame.edges_assignment.forEach((assignment, edge) => {
    const [from, to] = net.ends(edge);
    if (assignment === 'B') return;
    if (assignment === 'F' || Math.abs(frame.edges_foldAngle[edge]!) < 3) return;
    const folds = left[assignment as 'M' | 'V'];
    if (!takeFold(folds, from, to)) faults.push(`${letter}: edge ${edge} is no fold`);
  });
  for (const side of net.sides) {
    const isCut = side.edges.every(([from, to]) => findCut(lines.cuts, from, to) === 'straight');
    const cut = isCut ? 'straight' : findCut(lines.cuts, side.from, side.to);
    if (cut === null) faults.push(`${letter}: a cut edge is not cut at ${side.from.join(' ')}`);
    if (cut === null || cut === 'straight') continue;
    if (!cut.every((point) => isOver(side.beyond, point))) {
      faults.push(`${letter}: a flap shows at ${side.from.join(' ')}`);
    }
    const folds = left[side.angle > 0 ? 'V' : 'M'];
    const along = (p: Point): boolean =>
      Math.abs(cross(side.from, side.to, p)) / distance(side.from, side.to) < tolerance;
    const at = folds.findIndex(
      ([a, b]) =>
        along(a) &&
        along(b) &&
        distance(a, side.from) + distance(b, side.to) < distance(side.from, side.to),
    );
    if (at >= 0) folds.splice(at, 1);
    else faults.push(`${letter}: a flap does not fold at ${side.from.join(' ')}`);
  }
  const extra = left.M.length + left.V.length;
  if (extra > 0) faults.push(`${letter}: ${extra} folds that the model has not`);
  return faults;
}

/** What a report says of the ids. */
export interface IdsReport {
  printed: number;
  skipped: string[];
}

/** Letters as the columns of a table are ordered. */
const inOrder = (a: string, b: string): number => a.length - b.length || (a < b ? -1 : 1);

/** Each id is on both pieces, or twice on its own, or listed; `seams`: how many each pair has, by its letters. */
function checkIds(sheets: SheetFile[], ids: IdsReport, seams: Map<string, number>): string[] {
  const uses = new Map<string, string[]>(); // the pieces that show an id
  for (const [letter, { texts }] of sheets.flatMap((sheet) => [...sheet.pieces])) {
    for (const { text } of texts) {
      const [, other, number] = /^([A-Z]*)(\d+)$/.exec(text) ?? [];
      if (number === undefined) continue;
      const id = `${[letter, ...(other ? [other] : [])].sort(inOrder).join('-')}:${number}`;
      uses.set(id, [...(uses.get(id) ?? []), letter]);
    }
  }
  const faults: string[] = [];
  const all = [...seams].flatMap(([pair, count]) =>
    Array.from({ length: count }, (_, i) => `${pair}:${i + 1}`),
  );
  if (ids.printed + ids.skipped.length !== all.length)
    faults.push(`${all.length} seams, but not as many ids`);
  for (const id of all) {
    const found = uses.get(id) ?? [];
    const isComplete = id.includes('-') ? new Set(found).size === 2 : found.length >= 2;
    if (!isComplete && !ids.skipped.includes(id)) faults.push(`id ${id} is on one side only`);
  }
  const strange = [...uses.keys()].filter((id) => !all.includes(id));
  return [...faults, ...strange.map((id) => `there is no seam ${id}`)];
}

/** Everything that is wrong with the sheets of one run. */
export function checkSheets(
  sheets: SheetFile[],
  file: FoldFile,
  ids: IdsReport,
  margin: number,
): string[] {
  const drawn = new Map(sheets.flatMap((sheet) => [...sheet.pieces]));
  const faults = sheets.flatMap((sheet) => checkCuts(sheet, margin));
  const sides: CutSide[] = [];
  const pieceOf = new Map<number, string>(); // by face of the model
  const pieces = pieceLines(file, drawn);
  for (const { letter, frame } of pieces) {
    for (const face of frame['faces_foldwright:source']) pieceOf.set(face, letter);
  }
  const halves = new Map<string, number>(); // sides of seams, by the letters of their pieces
  for (const { letter, frame, net } of pieces) {
    const lines = drawn.get(letter);
    if (!lines) {
      faults.push(`${letter} is on no sheet`);
      continue;
    }
    sides.push(...net.sides);
    for (const { face, other } of net.sides) {
      const letters = new Set([pieceOf.get(face)!, pieceOf.get(other)!]);
      const pair = [...letters].sort(inOrder).join('-');
      halves.set(pair, (halves.get(pair) ?? 0) + 1);
    }
    faults.push(...checkEdges(letter, frame, lines, net), ...checkTexts(letter, lines));
    faults.push(...checkGuides(letter, lines));
  }
  const strips = sheets.flatMap((sheet) => [...sheet.strips]);
  faults.push(...strips.flatMap(([id, strip]) => checkStrip(id, strip, sides)));
  const seams = new Map([...halves].map(([pair, count]) => [pair, count / 2]));
  return [...faults, ...checkIds(sheets, ids, seams)];
}
