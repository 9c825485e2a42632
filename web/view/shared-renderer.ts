import type { Camera, Scene, WebGLRenderer } from 'three';
import type { AnyCanvas, Canvas2d, Context2d } from './context-2d.js';
import { rendererOn, type ModelScreen } from './model-screen.js';
import type { PictureSize } from './picture-size.js';
import { drawsInSoftware } from './webgl.js';

/**
 * One WebGL context for any number of screens: browsers bear about sixteen contexts and take the oldest away. Scenes
 * are drawn in turn on a canvas that nobody sees, as large as the largest screen, and copied to their own.
 */
export class SharedRenderer {
  readonly isInSoftware: boolean;
  private readonly renderer: WebGLRenderer;
  private readonly screens = new Set<SharedScreen>();
  /** Of what is drawn on. */
  private size: PictureSize = { width: 0, height: 0, density: 1 };

  /** @param canvas is on no page */
  constructor(
    readonly canvas: AnyCanvas,
    private readonly context: WebGL2RenderingContext,
  ) {
    this.isInSoftware = drawsInSoftware(context);
    this.renderer = rendererOn(canvas, context);
    canvas.addEventListener('webglcontextrestored', () => {
      for (const screen of this.screens) screen.redraw();
    });
  }

  /** Null where nothing can be copied to a canvas. */
  screenOn(canvas: AnyCanvas): ModelScreen | null {
    const drawn: Canvas2d = canvas;
    const context = drawn.getContext('2d');
    if (!context) return null;
    const screen = new SharedScreen(this, canvas, context);
    this.screens.add(screen);
    return screen;
  }

  prepare(scene: Scene, camera: Camera): void {
    this.renderer.compile(scene, camera);
  }

  /** Draws a scene in the lower left corner, where it stays until the next one is drawn; whether it could. */
  draw(scene: Scene, camera: Camera, { width, height, density }: PictureSize): boolean {
    if (this.context.isContextLost()) return false;
    this.fit(density);
    const { renderer } = this;
    renderer.setViewport(0, 0, width, height);
    // A scene clears no more than it fills.
    renderer.setScissor(0, 0, width, height);
    renderer.setScissorTest(true);
    renderer.render(scene, camera);
    return true;
  }

  /** Forgets a screen that has ended. */
  remove(screen: SharedScreen): void {
    this.screens.delete(screen);
  }

  /** Frees the context at once, which browsers do late. */
  end(): void {
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }

  /** Gives every screen room, and takes no new memory of the graphics card unless it has to. */
  private fit(density: number): void {
    const sizes = [...this.screens].map(({ size }) => size);
    const width = Math.max(...sizes.map((size) => size.width));
    const height = Math.max(...sizes.map((size) => size.height));
    const { size } = this;
    if (size.width === width && size.height === height && size.density === density) return;
    this.size = { width, height, density };
    this.renderer.setDrawingBufferSize(width, height, density);
  }
}

/** A canvas to which pictures of a scene are copied. */
class SharedScreen implements ModelScreen {
  readonly isInSoftware: boolean;
  size: PictureSize = { width: 0, height: 0, density: 1 };
  redraw: () => void = () => undefined;

  constructor(
    private readonly renderer: SharedRenderer,
    private readonly canvas: AnyCanvas,
    private readonly context: Context2d,
  ) {
    this.isInSoftware = renderer.isInSoftware;
    // Where the graphics card has this canvas as well, it is lost with the context.
    canvas.addEventListener('contextrestored', () => this.redraw());
  }

  prepare(scene: Scene, camera: Camera): void {
    this.renderer.prepare(scene, camera);
  }

  resize(size: PictureSize): void {
    this.size = size;
    this.canvas.width = Math.floor(size.width * size.density);
    this.canvas.height = Math.floor(size.height * size.density);
  }

  draw(scene: Scene, camera: Camera): void {
    const { canvas, context, renderer } = this;
    // While the context is lost, what was drawn last stays to be seen.
    if (!renderer.draw(scene, camera, this.size)) return;
    const { width, height } = canvas;
    const top = renderer.canvas.height - height;
    context.clearRect(0, 0, width, height);
    context.drawImage(renderer.canvas, 0, top, width, height, 0, 0, width, height);
  }

  onRestored(redraw: () => void): void {
    this.redraw = redraw;
  }

  end(): void {
    this.renderer.remove(this);
  }
}
