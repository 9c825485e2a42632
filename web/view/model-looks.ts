import type { Looks } from '../model/looks.js';
import type { ModelFile } from '../model/model-files.js';
import { LookedMesh } from './looked-mesh.js';
import type { ModelMesh } from './model-mesh.js';
import { PictureTextures } from './picture-textures.js';

/** Shows a model as its files say that it looks, in place of the colours of its parts. */
export class ModelLooks {
  private pictures = new PictureTextures([]);
  private looked: LookedMesh | null = null;
  /** Whether what is shown can move with the model. */
  private canMove = true;

  /** @param onChange is called when there is more to see than before */
  constructor(
    private readonly model: ModelMesh,
    private readonly onChange: () => void,
  ) {}

  /** Takes the pictures of the looks that come. */
  takePictures(pictures: readonly ModelFile[]): void {
    this.show(null);
    this.pictures.dispose();
    this.pictures = new PictureTextures(pictures);
  }

  /** @param looks null for the colours of the parts */
  show(looks: Pick<Looks, 'surface' | 'materials'> | null): void {
    const { model, looked } = this;
    looked?.mesh.removeFromParent();
    looked?.dispose();
    this.looked = looks && new LookedMesh(looks, this.pictures, model.corners, this.onChange);
    this.canMove = !looks?.surface.original;
    if (this.looked) model.group.add(this.looked.mesh);
  }

  dispose(): void {
    this.show(null);
    this.pictures.dispose();
  }

  /**
   * Decides what is drawn. A surface from before the model was simplified stands still.
   *
   * @param isFolded whether the model is whole
   */
  update(isFolded: boolean): void {
    const isShown = this.looked !== null && (this.canMove || isFolded);
    if (this.looked) this.looked.mesh.visible = isShown;
    this.model.draws({ faces: !isShown, lines: !isShown || this.canMove });
  }
}
