/** The pages that tell how to build a model: its cover, its pieces and the steps. */
import type { JobResult } from '../model/job.js';
import type { PrintOptions } from '../model/print-options.js';
import type { BuildingWords } from '../words/building.js';
import { buildingPlan } from './building-plan.js';
import { drawSteps } from './building-steps.js';
import { drawCover } from './cover.js';
import type { Look } from './line-style.js';
import { ModelViews } from './model-views.js';
import { Page } from './page-layout.js';
import { drawPieceList } from './piece-list.js';
import type { SheetDrawing } from './sheet-drawing.js';

export interface AssemblyInput {
  result: JobResult;
  title: string;
  /** Of the sheets; mm. */
  margin: number;
  options: PrintOptions;
  look: Look;
  words: BuildingWords;
}

const noteSize = 2.4;

/**
 * Faces in all small pictures together: 5000 faces in 20 pieces take some 8 s and 2 MB. Who builds more
 * does without some of the pictures.
 */
const mostFaces = 200_000;

/**
 * Draws them on paper of the sheets' size, but scaled to it: nothing on them is to be measured or cut. One
 * page with the cover, then a list of all pieces if there are several, then the steps. Where pieces times
 * faces exceed 100,000 the steps have no pictures of the model, from 200,000 on the list has none.
 */
export function assemblyPages(input: AssemblyInput): SheetDrawing[] {
  const { look, margin, options, result, title, words } = input;
  const [paper] = result.sheets;
  if (!paper || result.pieces.length === 0) return [];
  const pages: Page[] = [];
  const newPage = (): Page => {
    const page = new Page(paper, margin);
    pages.push(page);
    return page;
  };
  const views = new ModelViews(result);
  const plan = buildingPlan(result, options.flatFold);
  drawCover(newPage(), { title, result, plan, views, look, words, flatFold: options.flatFold });
  const pictures = (mostFaces * 3) / result.model.faces.length / result.pieces.length;
  if (result.pieces.length > 1)
    drawPieceList(newPage, { views, plan, words, hasPictures: pictures >= 1 });
  drawSteps(newPage, { views, plan, options, words, hasPictures: pictures >= 2 });
  pages.forEach((page, i) => {
    const note = words.pageNote({ page: i + 1, pages: pages.length });
    page.line(`${title} · ${note}`, [page.margin, page.margin - 1], noteSize, page.room);
  });
  return pages.map((page) => page.drawing());
}
