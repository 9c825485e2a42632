/** Reads back what a sheet's SVG draws; nothing here comes from the exporter. */
import { XMLParser } from 'fast-xml-parser';

/** mm, y up, from the sheet's lower left. */
export type Point = [x: number, y: number];

export interface SheetText {
  text: string;
  /** Middle of the baseline. */
  at: Point;
  /** Degrees, counter-clockwise. */
  angle: number;
  size: number;
  /** Where the file tells it; mm. */
  width?: number;
}

/** All that is drawn of one piece. */
export interface PieceLines {
  /** Closed walks, without repeating the first point. */
  cuts: Point[][];
  mountains: [Point, Point][];
  valleys: [Point, Point][];
  /** Lines from numbers to edges, and marks for tape. */
  guides: [Point, Point][];
  texts: SheetText[];
  /** Lines below numbers. */
  underlines: [Point, Point][];
}

/** What helps to print: rulers, a box, the title and a legend. */
export interface GuideLines {
  strokes: Point[][];
  texts: SheetText[];
}

export interface SheetFile {
  width: number;
  height: number;
  /** By letter. */
  pieces: Map<string, PieceLines>;
  /** Loose strips for glue, by the id of their seam. */
  strips: Map<string, PieceLines>;
  guide: GuideLines;
}

/** Of a letter of Helvetica, over the size of the font. */
const meanWidth = 0.55;

interface Element {
  'data-piece': string;
  'data-text'?: string;
  d: string;
  '#text': string;
  x: string;
  y: string;
  'font-size': string;
  'text-anchor': string;
  transform?: string;
}

interface Svg {
  width: string;
  height: string;
  viewBox: string;
  g: { id: string; path?: Element[]; text?: Element[] }[];
}

function parse(source: string): Svg {
  const parser = new XMLParser({
    ignoreAttributes: false,
    attributeNamePrefix: '',
    parseTagValue: false,
    isArray: (name) => ['g', 'path', 'text'].includes(name),
  });
  return (parser.parse(source) as { svg: Svg }).svg;
}

/** The id of a loose strip's seam, from what a file calls it; null for pieces. */
export function stripId(name: string): string | null {
  const strip = /^strip-(.+)$/.exec(name);
  return strip ? strip[1]! : null;
}

/** @throws if anything but closed polygons and single lines in mm is drawn */
export function readSheet(source: string): SheetFile {
  const svg = parse(source);
  const [width, height] = [Number.parseFloat(svg.width), Number.parseFloat(svg.height)];
  if (svg.width !== `${width}mm` || svg.viewBox !== `0 0 ${width} ${height}`) {
    throw new Error('the sheet is not in mm');
  }
  const pieces = new Map<string, PieceLines>();
  const strips = new Map<string, PieceLines>();
  const linesOf = <Key>(all: Map<Key, PieceLines>, key: Key): PieceLines => {
    const fresh: PieceLines = {
      cuts: [],
      mountains: [],
      valleys: [],
      guides: [],
      texts: [],
      underlines: [],
    };
    if (!all.has(key)) all.set(key, fresh);
    return all.get(key)!;
  };
  const pieceOf = ({ 'data-piece': letter }: Element): PieceLines => {
    const strip = stripId(letter);
    return strip === null ? linesOf(pieces, letter) : linesOf(strips, strip);
  };
  const up = (pair: string): Point => {
    const [x, y] = pair.trim().split(' ').map(Number);
    return [x!, height - y!];
  };
  const walks = (element: Element): string[] => element.d.split('M').slice(1);
  const group = (id: string) => svg.g.find((candidate) => candidate.id === id);
  for (const element of group('cut')?.path ?? []) {
    for (const walk of walks(element)) {
      if (!walk.endsWith('Z')) throw new Error('a cut is not closed');
      pieceOf(element).cuts.push(walk.slice(0, -1).split('L').map(up));
    }
  }
  for (const [id, kind] of [
    ['fold-mountain', 'mountains'],
    ['fold-valley', 'valleys'],
    ['guide', 'guides'],
  ] as const) {
    for (const element of group(id)?.path ?? []) {
      if (!element['data-piece']) continue;
      for (const walk of walks(element)) {
        const [from, to] = walk.split('L').map(up);
        pieceOf(element)[kind].push([from!, to!]);
      }
    }
  }
  const textOf = (element: Element): SheetText => {
    const turn = /^rotate\((\S+) (\S+) (\S+)\)$/.exec(
      element.transform ?? `rotate(0 ${element.x} ${element.y})`,
    );
    if (turn?.[2] !== element.x || turn[3] !== element.y) throw new Error('a text is moved');
    const [angle, size, text] = [-Number(turn[1]), Number(element['font-size']), element['#text']];
    const [x, y] = up(`${element.x} ${element.y}`);
    const half = element['text-anchor'] === 'start' ? (meanWidth * size * text.length) / 2 : 0;
    const on = (angle * Math.PI) / 180;
    return { text, at: [x + half * Math.cos(on), y + half * Math.sin(on)], angle, size };
  };
  for (const element of group('id')?.path ?? []) {
    if (element['data-text']) continue;
    const [from, to] = walks(element)[0]!.split('L').map(up);
    pieceOf(element).underlines.push([from!, to!]);
  }
  for (const element of group('id')?.text ?? []) pieceOf(element).texts.push(textOf(element));
  const guide: GuideLines = {
    strokes: (group('guide')?.path ?? [])
      .filter((element) => !element['data-text'] && !element['data-piece'])
      .flatMap(walks)
      .map((walk) => walk.replace('Z', '').split('L').map(up)),
    texts: (group('guide')?.text ?? []).map(textOf),
  };
  return { width, height, pieces, strips, guide };
}
