import {
  BufferAttribute,
  BufferGeometry,
  DirectionalLight,
  HemisphereLight,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  PerspectiveCamera,
  Scene,
  WebGLRenderer,
} from 'three';
import type { PictureSize } from './picture-size.js';
import type { SizeMessage } from './drawing.js';
import { addPaint, paintFaces } from './face-paint.js';
import { HatchMaterial } from './hatch-material.js';
import { extentOf, flatMesh } from './model-geometry.js';
import type { ModelMessage } from './model-message.js';
import { Orbit, viewHeight } from './orbit.js';
import { PartBorders } from './part-borders.js';
import { Redraw } from './redraw.js';

/** Lines along the borders of parts. */
const ink = '#232a31';

/** Radians per second of the slow turn, and ms between two of its steps. */
const turnSpeed = 0.25;
const turnInterval = 33;

/** A model in 3D, lit, flat-shaded and coloured by part; draws in frames, and only what changed. */
export class ModelScene {
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly camera = new PerspectiveCamera();
  private readonly orbit = new Orbit(this.camera);
  private readonly material = new HatchMaterial();
  private readonly mesh = new Mesh(new BufferGeometry(), this.material);
  private readonly borders = new LineSegments(
    new BufferGeometry(),
    new LineBasicMaterial({ color: ink }),
  );
  private readonly redraw = new Redraw(() => this.draw());
  private faces: Int32Array = new Int32Array();
  private edges: PartBorders | null = null;
  private visible = false;
  private turning = false;
  private lastTurn = -Infinity;

  /** @param canvas of a document or, in a worker, without one */
  constructor(canvas: HTMLCanvasElement | OffscreenCanvas, context: WebGL2RenderingContext) {
    this.renderer = new WebGLRenderer({ canvas, context });
    this.renderer.setClearAlpha(0);
    const sun = new DirectionalLight('#fff6e6', 2.1);
    sun.position.set(-0.7, 1, 0.9);
    // The light stays at the beholder's shoulder, so that no side is ever dark.
    this.camera.add(sun, sun.target);
    this.scene.add(this.camera, new HemisphereLight('#ffffff', '#b8a98c', 1.5));
    this.scene.add(this.mesh, this.borders);
    // Now, so that the first model does not have to wait for it.
    this.renderer.compile(this.scene, this.camera);
    canvas.addEventListener('webglcontextrestored', () => this.redraw.request());
  }

  take(message: ModelMessage | SizeMessage): void {
    switch (message.type) {
      case 'model':
        this.show(message);
        break;
      case 'labels':
        this.paint(message.labels);
        break;
      case 'hatched':
        this.material.hatched = message.hatched;
        break;
      case 'turning':
        this.turnAlone(message.turning);
        break;
      case 'turn':
        this.turning = false;
        this.orbit.turn(message);
        break;
      case 'size':
        this.resize(message);
        break;
    }
    this.redraw.request();
  }

  private show({ vertices, faces }: Extract<ModelMessage, { type: 'model' }>): void {
    const { positions, normals, uvs } = flatMesh(vertices, faces);
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(positions, 3));
    geometry.setAttribute('normal', new BufferAttribute(normals, 3));
    geometry.setAttribute('uv', new BufferAttribute(uvs, 2));
    addPaint(geometry, faces.length / 3);
    this.mesh.geometry.dispose();
    this.mesh.geometry = geometry;
    this.faces = faces;
    this.edges = null;
    paintFaces(geometry, new Int32Array(faces.length / 3).fill(-1));
    this.showBorders(new Float32Array());
    this.orbit.reset(extentOf(positions, viewHeight));
  }

  private paint(labels: Int32Array): void {
    const { geometry } = this.mesh;
    const positions = geometry.getAttribute('position') as BufferAttribute | undefined;
    if (!positions || positions.count !== 3 * labels.length) return;
    paintFaces(geometry, labels);
    this.edges ??= new PartBorders(this.faces);
    this.showBorders(this.edges.lines(labels, positions.array as Float32Array));
  }

  private showBorders(lines: Float32Array): void {
    this.borders.geometry.dispose();
    this.borders.geometry = new BufferGeometry();
    this.borders.geometry.setAttribute('position', new BufferAttribute(lines, 3));
  }

  private turnAlone(turning: boolean): void {
    if (turning && !this.turning) requestAnimationFrame(this.turnStep);
    this.turning = turning;
  }

  private readonly turnStep = (now: number): void => {
    if (!this.turning) return;
    requestAnimationFrame(this.turnStep);
    if (now - this.lastTurn < turnInterval) return;
    // After a pause, as when the page was in the background, it goes on where it was.
    const seconds = Math.min(now - this.lastTurn, 100) / 1000;
    this.lastTurn = now;
    this.orbit.turn({ around: turnSpeed * seconds, down: 0, away: 1 });
    this.redraw.request();
  };

  private resize({ width, height, density }: PictureSize): void {
    this.visible = width > 0 && height > 0;
    if (!this.visible) return;
    this.renderer.setPixelRatio(density);
    this.renderer.setSize(width, height, false);
    this.orbit.fit(width / height);
    // A resized canvas is empty: waiting for the next frame would flash.
    this.draw();
  }

  private draw(): void {
    if (this.visible) this.renderer.render(this.scene, this.camera);
  }
}
