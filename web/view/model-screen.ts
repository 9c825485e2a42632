import { WebGLRenderer, type Camera, type Scene } from 'three';
import type { AnyCanvas } from './context-2d.js';
import type { PictureSize } from './picture-size.js';
import { drawsInSoftware } from './webgl.js';

/** Where the scene of a model is seen. */
export interface ModelScreen {
  /** Whether software stands in for a graphics card. */
  readonly isInSoftware: boolean;
  /** Compiles what a scene needs, so that its first model does not have to wait for it. */
  prepare(scene: Scene, camera: Camera): void;
  /** What was drawn may be gone then. */
  resize(size: PictureSize): void;
  draw(scene: Scene, camera: Camera): void;
  /** @param redraw is called when what was drawn is lost and can be drawn anew */
  onRestored(redraw: () => void): void;
  end(): void;
}

/** Draws on a canvas with its WebGL context, over whatever lies below. */
export function rendererOn(canvas: AnyCanvas, context: WebGL2RenderingContext): WebGLRenderer {
  const renderer = new WebGLRenderer({ canvas, context });
  renderer.setClearAlpha(0);
  return renderer;
}

/** Ends a renderer with its context: browsers bear few at a time, and free those of lost canvases late. */
export function endRenderer(renderer: WebGLRenderer): void {
  renderer.dispose();
  renderer.forceContextLoss();
}

/** A canvas with a WebGL context of its own. */
export class OwnScreen implements ModelScreen {
  readonly isInSoftware: boolean;
  private readonly renderer: WebGLRenderer;

  constructor(
    private readonly canvas: AnyCanvas,
    context: WebGL2RenderingContext,
  ) {
    this.isInSoftware = drawsInSoftware(context);
    this.renderer = rendererOn(canvas, context);
  }

  prepare(scene: Scene, camera: Camera): void {
    this.renderer.compile(scene, camera);
  }

  resize({ width, height, density }: PictureSize): void {
    this.renderer.setPixelRatio(density);
    this.renderer.setSize(width, height, false);
  }

  draw(scene: Scene, camera: Camera): void {
    this.renderer.render(scene, camera);
  }

  onRestored(redraw: () => void): void {
    this.canvas.addEventListener('webglcontextrestored', redraw);
  }

  end(): void {
    endRenderer(this.renderer);
  }
}
