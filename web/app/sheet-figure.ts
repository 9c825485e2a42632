import type { JobResult } from '../model/job.js';
import { partColour } from '../model/part-colours.js';
import { partHatch } from '../view/part-hatches.js';
import { sheetPicture, type PiecePaint } from '../view/sheet-picture.js';
import type { Words } from '../words/words.js';
import { make } from './dom.js';

/** What a sheet on the page was made of; two that were made of the same look the same. */
export interface SheetParts {
  source: string;
  paints: ReadonlyMap<string, PiecePaint>;
  caption: string;
  /** Of the width of the widest sheet. */
  share: number;
}

export function partsOf(
  words: Words,
  result: JobResult,
  index: number,
  source: string,
): SheetParts {
  const pieces = result.pieces.filter((piece) => piece.sheet === index);
  const paints = new Map(
    pieces.map(({ name, part }) => [name, { colour: partColour(part), hatch: partHatch(part) }]),
  );
  const caption = words.result.caption(index + 1, result.sheets.length, [...paints.keys()]);
  const widest = Math.max(...result.sheets.map(({ width }) => width));
  return { source, paints, caption, share: result.sheets[index]!.width / widest };
}

export function keyOf({ source, paints, caption, share }: SheetParts): string {
  return JSON.stringify([source, [...paints], caption, share]);
}

/** One sheet with its caption. */
export function drawSheet({ source, paints, caption, share }: SheetParts): HTMLLIElement {
  const picture = sheetPicture(source, paints, caption);
  const figure = make('figure', {}, picture, make('figcaption', { textContent: caption }));
  figure.style.setProperty('--share', String(share));
  return make('li', { className: 'sheet' }, figure);
}
