import type { JobOptions } from '../../model/job-options.js';
import type { Message } from '../../model/message.js';
import type { ModelFile } from '../../model/model-files.js';
import { polygonFile } from '../polygon-file.js';
import { notice } from '../read-model.js';
import { mostTriangles } from '../soup.js';
import { unreadable } from '../unreadable.js';
import { foldFrames, type FoldFrame } from './fold-frames.js';
import { foldedForm } from './folded-form.js';
import { netFrames } from './folded-nets.js';

/** Units of the format that the options know, too. */
const units = ['mm', 'cm', 'm', 'in'] as const;

/** What a FOLD file comes to as a model. */
export interface FoldModel {
  file: ModelFile;
  looks: null;
  notices: Message[];
  usual: Partial<Pick<JobOptions, 'up' | 'unit'>>;
}

/** The surface of a folded form. */
function surfaceOf(frame: FoldFrame): ModelFile {
  const positions = [...frame.numbers('vertices_coords', 3)];
  const faces = frame.indexLists('faces_vertices', 3, positions.length / 3);
  const firstCorners = [0];
  for (const { length } of faces) firstCorners.push(firstCorners.at(-1)! + length);
  const triangles = firstCorners.at(-1)! - 2 * faces.length;
  if (triangles > mostTriangles) throw unreadable('too-many-triangles', { most: mostTriangles });
  const materials = faces.map(() => -1);
  return polygonFile({ positions, firstCorners, vertices: faces.flat(), places: null, materials });
}

/**
 * The folded form of a FOLD file as a model like any other. Its nets are left, which is told; cost and memory are those
 * of the whole file.
 *
 * @throws Unreadable for a file that has no folded form, or is damaged
 */
export function readFold(file: ModelFile): FoldModel {
  const frames = foldFrames(file);
  const form = foldedForm(file.name, frames);
  const pieces = netFrames(frames).length;
  const unit = units.find((name) => name === form.text('frame_unit'));
  return {
    file: surfaceOf(form),
    looks: null,
    notices: pieces > 0 ? [notice('fold-nets-unused', { pieces })] : [],
    // Of files of Foldwright it is known which way is up.
    usual: { ...(pieces > 0 && { up: 'y' }), ...(unit && { unit }) },
  };
}
