import type { Piece } from '../../model/job.js';
import type { Point } from '../point.js';
import { boxOf } from '../polygon.js';
import { bleed } from './bleed.js';
import { coverConvex, coverTriangle, type Grid } from './cover.js';
import { bledFlaps, bleedReach } from './flap-bleed.js';
import type { PaintPlan } from './paint-plan.js';
import { SurfaceMap } from './surface-map.js';

/** A piece in its colours. */
export interface PaintedPiece extends Grid {
  /** 4 per dot: red, green, blue, and 255 where it is coloured, else 0. */
  rgba: Uint8Array;
}

/** Above, memory runs short in browsers: A3 at 600 dots to the inch has 70 million. */
const mostDots = 72_000_000;
const longestSide = 32_000;

/** Where a vertex of a piece lies on the sheet. */
function placeOf({ vertices, x, y }: Piece, vertex: number): Point {
  return [x + vertices[2 * vertex]!, y + vertices[2 * vertex + 1]!];
}

/** A grid around points, on the raster that the whole sheet has from its upper left. */
function gridAround(points: readonly Point[], sheetHeight: number, dpi: number): Grid {
  const [left, bottom, right, top] = boxOf(points);
  const inch = 25.4;
  const [across, up] = [right - left, top - bottom].map((length) => length + 4 * bleedReach);
  const density = Math.min(
    dpi / inch,
    longestSide / across!,
    longestSide / up!,
    Math.sqrt(mostDots / (across! * up!)),
  );
  const first = Math.floor((left - 2 * bleedReach) * density);
  const upper = Math.floor((sheetHeight - top - 2 * bleedReach) * density);
  return {
    width: Math.ceil((right + 2 * bleedReach) * density) - first,
    height: Math.ceil((sheetHeight - bottom + 2 * bleedReach) * density) - upper,
    left: first / density,
    top: sheetHeight - upper / density,
    density,
  };
}

/** Paints pieces of one result. */
export class PiecePainter {
  private readonly map: SurfaceMap;

  constructor(private readonly plan: PaintPlan) {
    this.map = new SurfaceMap(plan);
  }

  /** The dots that a piece takes on a sheet of this height in mm. */
  gridOf(piece: Piece, sheetHeight: number): Grid {
    const { dpi, flapBleed } = this.plan;
    const corners = Array.from({ length: piece.vertices.length / 2 }, (_, vertex) =>
      placeOf(piece, vertex),
    );
    return gridAround([...corners, ...bledFlaps(piece, flapBleed).flat()], sheetHeight, dpi);
  }

  /**
   * Paints a piece where it lies on its sheet: every face as it looks, beyond cuts half a millimetre of
   * the nearest colour, and of flaps as much as was asked for.
   */
  paint(piece: Piece, grid: Grid): PaintedPiece {
    const rgba = new Uint8Array(4 * grid.width * grid.height);
    const covered = new Uint8Array(grid.width * grid.height);
    for (const flap of bledFlaps(piece, this.plan.flapBleed)) {
      coverConvex(grid, flap, bleedReach, (dot) => (covered[dot] = 2));
    }
    const plain = this.plan.colourOf(piece);
    for (let face = 0; face < piece.sources.length; ++face) {
      const triangle = [0, 1, 2].map((i) => placeOf(piece, piece.faces[3 * face + i]!));
      const look = this.map.lookOf(piece.sources[face]!, plain);
      coverTriangle(grid, triangle as [Point, Point, Point], (dot, b, c) => {
        const colour = look(b, c);
        for (let i = 0; i < 3; ++i) rgba[4 * dot + i] = Math.round(colour[i]!);
        rgba[4 * dot + 3] = 255;
        covered[dot] = 1;
      });
    }
    bleed(grid, rgba, covered, bleedReach);
    return { ...grid, rgba };
  }
}
