/** A small picture of a model in the colours of its parts, for lists of many. */
import type { JobResult } from '../model/job.js';
import { drawModel, fitOf, pieceRgb } from './model-picture.js';
import { ModelViews } from './model-views.js';
import { Page } from './page-layout.js';
import { writePng } from './png.js';
import type { Print } from './print.js';

/** Of the paper that it is drawn on, in mm. */
const paper = { width: 64, height: 48 };
/** Pixels to the inch: 240 across. */
const dpi = 95.25;

/** What is hidden takes time to find: 20,000 faces some seconds. */
const mostFaces = 20_000;

/** A PNG of 240 x 180 pixels; null for a model of more than 20,000 triangles, or without pieces. */
export async function modelThumbnail(result: JobResult, print: Print): Promise<Uint8Array | null> {
  if (result.pieces.length === 0 || result.model.faces.length / 3 > mostFaces) return null;
  const page = new Page(paper, 0);
  const views = new ModelViews(result);
  const { areas, scene, view } = views.from('front-left');
  const frame = {
    left: page.margin,
    bottom: page.margin,
    width: page.room,
    height: page.height - 2 * page.margin,
  };
  const fit = fitOf(views, view, frame);
  const isThere = (): boolean => true;
  const colourOf = (piece: number): readonly number[] => pieceRgb(views, piece);
  page.draw(drawModel({ views, view, scene, areas, isThere, colourOf, fit }));
  const sheets = [page.drawing()];
  return writePng({ ...print, machine: 'none', dpi, sheets, backs: [], pages: [] }, 0);
}
