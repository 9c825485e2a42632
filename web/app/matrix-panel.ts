import type { MatrixPicture } from '../model/job.js';
import { openPicture } from '../view/picture.js';
import { find } from './dom.js';

/** The foldability matrix while it is learned, and with its blocks once it is clustered. */
export class MatrixPanel {
  private readonly words = find('#matrix-words', HTMLElement);
  private readonly picture = openPicture(find('#matrix', HTMLElement));
  private empty = true;

  clear(): void {
    this.empty = true;
    this.words.textContent = 'every pair of faces is a dot';
    this.picture.tell({ type: 'nothing' });
  }

  /** Says why there is nothing to see if the parts were chosen without learning. */
  settle(): void {
    if (this.empty) this.words.textContent = 'nothing had to be learned for these parts';
  }

  show(matrix: MatrixPicture): void {
    this.empty = false;
    this.words.textContent = matrix.blocks ? 'each frame is a part' : 'darker: more often together';
    this.picture.tell({ type: 'matrix', matrix });
  }
}
