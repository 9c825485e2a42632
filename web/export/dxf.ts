import { inCuttingOrder } from './cutting-order.js';
import { dxfText, type DxfEntity, type DxfLayer, type Pair } from './dxf-file.js';
import type { FontSet } from './font-set.js';
import { outlinesOf, walksOf } from './outlines.js';
import type { Point, Segment } from './point.js';
import { fontsOf, type Print } from './print.js';
import type { SheetDrawing } from './sheet-drawing.js';
import { underlineOf } from './text-line.js';

/** In the colours that sheets for machines have. */
const layers = [
  { name: 'REGISTRATION', colour: 7 },
  { name: 'MOUNTAIN', colour: 5 },
  { name: 'VALLEY', colour: 3 },
  { name: 'TEXT', colour: 6 },
  { name: 'CUT', colour: 1 },
] as const satisfies readonly DxfLayer[];

type LayerName = (typeof layers)[number]['name'];

function line(layer: LayerName, [[ax, ay], [bx, by]]: Segment): DxfEntity {
  const pairs: Pair[] = [
    [10, ax],
    [20, ay],
    [30, 0],
    [11, bx],
    [21, by],
    [31, 0],
  ];
  return { type: 'LINE', layer, pairs };
}

function polyline(layer: LayerName, walk: readonly Point[], closed: boolean): DxfEntity {
  const pairs: Pair[] = [
    [90, walk.length],
    [70, closed ? 1 : 0],
    ...walk.flatMap(([x, y]): Pair[] => [
      [10, x],
      [20, y],
    ]),
  ];
  return { type: 'LWPOLYLINE', layer, pairs };
}

function marks({ registration }: SheetDrawing): DxfEntity[] {
  if (!registration) return [];
  return [
    polyline('REGISTRATION', registration.square, true),
    ...registration.corners.map((corner) => polyline('REGISTRATION', corner, false)),
  ];
}

/** All that a machine is to do, in the order in which it best does it: cutting comes last. */
function entitiesOf(sheet: SheetDrawing, fonts: FontSet): DxfEntity[] {
  const pieces = inCuttingOrder(sheet.pieces, [0, sheet.height]);
  const texts = pieces.flatMap((piece) => piece.texts);
  const letters = texts.flatMap((text) => walksOf(outlinesOf(text, fonts)));
  const underlines = texts.filter(({ underlined }) => underlined).map((text) => underlineOf(text));
  return [
    ...marks(sheet),
    ...pieces.flatMap(({ mountains }) => mountains.map((fold) => line('MOUNTAIN', fold))),
    ...pieces.flatMap(({ valleys }) => valleys.map((fold) => line('VALLEY', fold))),
    ...pieces.flatMap(({ guides }) => guides.map((guide) => line('TEXT', guide))),
    ...letters.map((walk) => polyline('TEXT', walk, true)),
    ...underlines.map((underline) => line('TEXT', underline.line)),
    ...pieces.flatMap(({ cuts }) => cuts.map((walk) => polyline('CUT', walk, true))),
  ];
}

/**
 * One sheet, counted from 0, as a DXF drawing (release 2000) in mm, y up, from the sheet's lower
 * left: closed polylines for cuts, lines for folds, texts as outlines, and neither rulers nor legend.
 * Windows come before the outline around them. The same print gives the same text.
 */
export async function writeDxf(print: Print, sheet: number): Promise<string> {
  const drawing = print.sheets[sheet]!;
  const { width, height } = drawing;
  const entities = entitiesOf(drawing, await fontsOf(print));
  return dxfText({ width, height, layers, entities });
}
