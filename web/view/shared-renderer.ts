import type { Camera, Scene, WebGLRenderer } from 'three';
import type { AnyCanvas } from './context-2d.js';
import { endRenderer, rendererOn, type ModelScreen } from './model-screen.js';
import type { PictureSize } from './picture-size.js';
import { drawsInSoftware } from './webgl.js';

/**
 * One WebGL context for any number of screens: browsers bear about sixteen contexts and take the oldest away. Scenes
 * are drawn in turn on a canvas that nobody sees.
 */
export class SharedRenderer {
  readonly isInSoftware: boolean;
  private readonly renderer: WebGLRenderer;
  private readonly screens = new Set<SharedScreen>();
  private size: PictureSize = { width: 0, height: 0, density: 1 };

  /** @param canvas is on no page */
  constructor(
    canvas: AnyCanvas,
    private readonly context: WebGL2RenderingContext,
  ) {
    this.isInSoftware = drawsInSoftware(context);
    this.renderer = rendererOn(canvas, context);
    canvas.addEventListener('webglcontextrestored', () => {
      for (const screen of this.screens) screen.redraw();
    });
  }

  /** @param show takes what is on the canvas to where it is seen, at once: the next scene overwrites it */
  newScreen(show: () => void): ModelScreen {
    const screen = new SharedScreen(this, show);
    this.screens.add(screen);
    return screen;
  }

  prepare(scene: Scene, camera: Camera): void {
    this.renderer.compile(scene, camera);
  }

  /** Fills the canvas with a scene; false while the context is lost. */
  draw(scene: Scene, camera: Camera, size: PictureSize): boolean {
    if (this.context.isContextLost()) return false;
    const { width, height, density } = size;
    const { renderer, size: last } = this;
    // Memory of the graphics card is taken anew with each size; pictures side by side mostly have the same.
    if (last.width !== width || last.height !== height || last.density !== density) {
      renderer.setDrawingBufferSize(width, height, density);
      this.size = size;
    }
    renderer.render(scene, camera);
    return true;
  }

  /** Forgets a screen that has ended. */
  remove(screen: SharedScreen): void {
    this.screens.delete(screen);
  }

  end(): void {
    endRenderer(this.renderer);
  }
}

/** Where pictures of one scene are taken to. */
class SharedScreen implements ModelScreen {
  redraw: () => void = () => undefined;
  private size: PictureSize = { width: 0, height: 0, density: 1 };

  constructor(
    private readonly renderer: SharedRenderer,
    private readonly show: () => void,
  ) {}

  get isInSoftware(): boolean {
    return this.renderer.isInSoftware;
  }

  prepare(scene: Scene, camera: Camera): void {
    this.renderer.prepare(scene, camera);
  }

  resize(size: PictureSize): void {
    this.size = size;
  }

  /** While the context is lost, what was drawn last stays to be seen. */
  draw(scene: Scene, camera: Camera): void {
    if (this.renderer.draw(scene, camera, this.size)) this.show();
  }

  onRestored(redraw: () => void): void {
    this.redraw = redraw;
  }

  end(): void {
    this.renderer.remove(this);
  }
}
