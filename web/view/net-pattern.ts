/** Nets on the screen of which nothing is known but their faces and folds: piece by piece, without flaps. */
import type { Piece } from '../model/job.js';
import { partColour } from '../model/part-colours.js';
import { shape } from './svg-shape.js';

/** Between pieces, as a share of the largest. */
const gap = 0.05;

/** Width over height that rows of pieces come to, about. */
const aspect = 1.4;

/** What is drawn of a piece, as the data of paths. */
function linesOf({ assignments, edges, vertices }: Piece, letter: string): string {
  const at = (vertex: number): string => `${vertices[2 * vertex]!} ${-vertices[2 * vertex + 1]!}`;
  return [...assignments]
    .map((kind, edge) =>
      kind === letter ? `M${at(edges[2 * edge]!)}L${at(edges[2 * edge + 1]!)}` : '',
    )
    .join('');
}

function facesOf({ faces, vertices }: Piece): string {
  const corner = (vertex: number): string =>
    `${vertices[2 * vertex]!} ${-vertices[2 * vertex + 1]!}`;
  let data = '';
  for (let at = 0; at < faces.length; at += 3) {
    data += `M${corner(faces[at]!)}L${corner(faces[at + 1]!)}L${corner(faces[at + 2]!)}Z`;
  }
  return data;
}

/** Mountains dashed and dotted, valleys dashed, as on paper; in shares of the width of a line. */
const strokes = {
  M: { stroke: '#c0392b', 'stroke-dasharray': '6 2 1 2' },
  V: { stroke: '#2056b0', 'stroke-dasharray': '4 3' },
  B: { stroke: '#232a31' },
} as const;

function drawPiece(piece: Piece, left: number, top: number, width: number): SVGElement {
  const { x, y } = cornerOf(piece);
  const group = shape('g', {
    transform: `translate(${left - x} ${top + y + piece.height})`,
    'data-area': piece.name,
  });
  const colour = partColour(piece.part);
  group.append(
    shape('path', { d: facesOf(piece), fill: colour, stroke: colour, 'stroke-width': width / 2 }),
  );
  for (const [letter, { stroke, ...rest }] of Object.entries(strokes)) {
    const dashes = 'stroke-dasharray' in rest ? rest['stroke-dasharray'].split(' ') : [];
    const dash = dashes.map((length) => Number(length) * width).join(' ');
    const look = { fill: 'none', stroke, 'stroke-width': width, 'stroke-linecap': 'round' };
    const d = linesOf(piece, letter);
    if (d === '') continue;
    group.append(shape('path', { d, ...look, ...(dash !== '' && { 'stroke-dasharray': dash }) }));
  }
  return group;
}

/** The lower left of all vertices. */
function cornerOf({ vertices }: Piece): { x: number; y: number } {
  let [x, y] = [Infinity, Infinity];
  for (let at = 0; at < vertices.length; at += 2) {
    x = Math.min(x, vertices[at]!);
    y = Math.min(y, vertices[at + 1]!);
  }
  return { x, y };
}

/** A picture of pieces in rows, the highest first, each in the colour of its part; `description` is for screen readers. */
export function netPattern(pieces: readonly Piece[], description: string): SVGElement {
  const sorted = [...pieces].sort((a, b) => b.height - a.height);
  const largest = Math.max(...sorted.map(({ width, height }) => Math.max(width, height)));
  const space = gap * largest;
  const area = sorted.reduce((sum, p) => sum + (p.width + space) * (p.height + space), 0);
  const room = Math.max(Math.sqrt(area * aspect), ...sorted.map(({ width }) => width));
  const svg = shape('svg', { role: 'img', 'aria-label': description });
  // Thin beside the picture, however large the model is.
  const line = room / 600;
  let [left, top, row, right] = [0, 0, 0, 0];
  for (const piece of sorted) {
    if (left > 0 && left + piece.width > room) [left, top, row] = [0, top + row + space, 0];
    svg.append(drawPiece(piece, left, top, line));
    left += piece.width + space;
    right = Math.max(right, left - space);
    row = Math.max(row, piece.height);
  }
  svg.setAttribute('viewBox', `${-space} ${-space} ${right + 2 * space} ${top + row + 2 * space}`);
  return svg;
}
