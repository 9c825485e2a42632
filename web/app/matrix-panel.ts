import type { MatrixPicture } from '../model/job.js';
import { drawMatrix } from '../view/matrix-picture.js';
import { Picture } from '../view/picture.js';
import { find } from './dom.js';

/** The foldability matrix while it is learned, and with its blocks once it is clustered. */
export class MatrixPanel {
  private readonly canvas = find('#matrix', HTMLCanvasElement);
  private readonly words = find('#matrix-words', HTMLElement);
  private matrix: MatrixPicture | null = null;
  private readonly picture = new Picture(this.canvas, (context, width, height) => {
    if (this.matrix) drawMatrix(context, width, height, this.matrix);
  });

  clear(): void {
    this.matrix = null;
    this.words.textContent = 'every pair of faces is a dot';
    this.picture.request();
  }

  /** Says why there is nothing to see if the parts were chosen without learning. */
  settle(): void {
    if (!this.matrix) this.words.textContent = 'nothing had to be learned for these parts';
  }

  show(matrix: MatrixPicture): void {
    this.matrix = matrix;
    this.words.textContent = matrix.blocks
      ? 'each frame is a part'
      : 'darker: unfolds together more often';
    this.picture.request();
  }
}
