import type { MatrixPicture } from '../model/job.js';
import { openPicture } from '../view/picture.js';
import { Panel } from './panel.js';

/** The foldability matrix while it is learned, and with its blocks once it is clustered. */
export class MatrixPanel extends Panel {
  private readonly words = this.find('#matrix-words', HTMLElement);
  private readonly picture = openPicture(this.find('#matrix', HTMLElement), this.place.life);

  clear(): void {
    this.words.textContent = this.told.pictures.matrixToCome;
    this.picture.post({ type: 'nothing' });
  }

  /** Shows the matrix of a run whose parts are chosen; null if nothing was learned for them. */
  finish(matrix: MatrixPicture | null): void {
    this.clear();
    if (matrix) this.show(matrix);
    else this.words.textContent = this.told.pictures.nothingLearned;
  }

  show(matrix: MatrixPicture): void {
    const { blocks, darker } = this.told.pictures;
    this.words.textContent = matrix.blocks ? blocks : darker;
    this.picture.post({ type: 'matrix', matrix });
  }
}
