/** Sheets for cutting machines: docs/paper.md says what their programs ask for. */
import type { Notice } from '../model/job.js';
import type { Machine } from '../model/print-options.js';
import { inCuttingOrder } from './cutting-order.js';
import { boxOf } from './polygon.js';
import { piecesInQuietZones, quietMargin, registrationMarks } from './registration.js';
import type { SheetDrawing } from './sheet-drawing.js';

/**
 * What Design Space leaves for its own marks at each edge of the sheet when it cuts what was printed:
 * on A4 and Letter, for which Cricut tells sizes, 13.4 to 13.7 mm; mm.
 */
export const cricutBorder = 13.7;

/**
 * A sheet with nothing on it but what the machine cuts, scores and draws, in the order of cutting, and the
 * pictures of pieces that are printed before.
 */
export function forMachine(sheet: SheetDrawing, machine: Machine): SheetDrawing {
  const { width, height, pieces } = sheet;
  return {
    ...sheet,
    // The blades of these machines start at the upper left of the mat.
    pieces: inCuttingOrder(pieces, [0, height]),
    frame: { strokes: [], texts: [] },
    ...(machine === 'silhouette' && { registration: registrationMarks(width, height) }),
  };
}

/** Width and height of all that is cut. */
function extent({ pieces }: SheetDrawing): [width: number, height: number] {
  const points = pieces.flatMap(({ cuts }) => cuts.flat());
  if (points.length === 0) return [0, 0];
  const [left, bottom, right, top] = boxOf(points);
  return [right - left, top - bottom];
}

function silhouetteNotices(sheets: readonly SheetDrawing[]): Notice[] {
  const pieces = sheets.flatMap(piecesInQuietZones);
  if (pieces.length === 0) return [];
  return [{ code: 'marks-not-free', params: { pieces, margin_mm: quietMargin } }];
}

function cricutNotices(sheets: readonly SheetDrawing[]): Notice[] {
  const border = 2 * cricutBorder;
  const large = sheets.flatMap((sheet, i) => {
    const [width, height] = extent(sheet);
    return width > sheet.width - border || height > sheet.height - border ? [i + 1] : [];
  });
  if (large.length === 0) return [];
  const { width, height } = sheets[large[0]! - 1]!;
  const params = {
    sheets: large,
    width_mm: width - border,
    height_mm: height - border,
    margin_mm: Math.ceil(cricutBorder),
  };
  return [{ code: 'cricut-area', params }];
}

/** What a person should know before sheets go to a machine. */
export function machineNotices(sheets: readonly SheetDrawing[], machine: Machine): Notice[] {
  if (machine === 'silhouette') return silhouetteNotices(sheets);
  return machine === 'cricut' ? cricutNotices(sheets) : [];
}
