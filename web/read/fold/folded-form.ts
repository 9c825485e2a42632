/** Which frame of a FOLD file is the model. */
import type { FoldFault } from '../../words/messages.js';
import { badFold, type FoldFrame } from './fold-frames.js';

/** Whether points have a third coordinate, and not all of them the same. */
function isInSpace(frame: FoldFrame): boolean {
  const key = 'vertices_coords';
  const points = frame.has(key) ? frame.list(key) : [];
  const heights = points.map((point) => (Array.isArray(point) ? Number(point[2] ?? 0) : NaN));
  return heights.some((height) => height !== heights[0]);
}

/** What a file without a model in space has instead. */
function insteadOf(frames: readonly FoldFrame[]): FoldFault {
  if (frames.some((frame) => frame.isOf('foldedForm') && frame.has('vertices_coords'))) {
    return { what: 'flat' };
  }
  const isPattern = (frame: FoldFrame): boolean =>
    frame.isOf('creasePattern') || frame.has('edges_assignment') || frame.has('faces_vertices');
  return { what: frames.some(isPattern) ? 'pattern' : 'nothing' };
}

/**
 * The first folded form in space, or else, as not all programs say what their frames are, the first frame in space.
 *
 * @throws Unreadable for a file with nothing but flat patterns
 */
export function foldedForm(file: string, frames: readonly FoldFrame[]): FoldFrame {
  const folded = frames.filter((frame) => frame.isOf('foldedForm'));
  const found = [...folded, ...frames].find(isInSpace);
  if (!found) throw badFold(file, insteadOf(frames));
  return found;
}
