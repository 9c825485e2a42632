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
import { addPaint, paintFaces } from './face-paint.js';
import { HatchMaterial } from './hatch-material.js';
import { extentOf, flatMesh } from './model-geometry.js';
import { Orbit, viewHeight } from './orbit.js';
import { PartBorders } from './part-borders.js';
import { Redraw } from './redraw.js';

/** Lines along the borders of parts. */
const ink = '#232a31';

/** Radians per second of the slow turn, and ms between two of its steps. */
const turnSpeed = 0.25;
const turnInterval = 33;

// More pixels than this cannot be seen and are slow to fill.
const mostDense = 2;

/** A model in 3D on a canvas, lit, flat-shaded and coloured by part; draws only what changes. */
export class ModelView {
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly camera = new PerspectiveCamera();
  private readonly material = new HatchMaterial();
  private readonly mesh = new Mesh(new BufferGeometry(), this.material);
  private readonly borders = new LineSegments(
    new BufferGeometry(),
    new LineBasicMaterial({ color: ink }),
  );
  private readonly orbit: Orbit;
  private readonly redraw = new Redraw(() => this.draw());
  private faces: Int32Array = new Int32Array();
  private edges: PartBorders | null = null;
  private turning = false;
  private lastTurn = 0;

  constructor(
    private readonly canvas: HTMLCanvasElement,
    context: WebGL2RenderingContext,
  ) {
    this.renderer = new WebGLRenderer({ canvas, context });
    this.renderer.setClearAlpha(0);
    const sun = new DirectionalLight('#fff6e6', 2.1);
    sun.position.set(-0.7, 1, 0.9);
    // The light stays at the beholder's shoulder, so that no side is ever dark.
    this.camera.add(sun, sun.target);
    this.scene.add(this.camera, new HemisphereLight('#ffffff', '#b8a98c', 1.5));
    this.scene.add(this.mesh, this.borders);
    const request = (): void => this.redraw.request();
    this.orbit = new Orbit(this.camera, canvas, request, () => this.rest());
    // Now, so that the first model does not have to wait for it.
    this.renderer.compile(this.scene, this.camera);
    new ResizeObserver(() => this.resize()).observe(canvas);
    canvas.addEventListener('webglcontextrestored', request);
  }

  /** Shows another model, without parts, from the first point of view; frees the one before. */
  setModel(vertices: Float32Array | Float64Array, faces: Int32Array): void {
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
    this.drawBorders(new Float32Array());
    this.orbit.reset(extentOf(positions, viewHeight));
  }

  /** Colours the faces by their parts; -1 is blank paper. Labels of another model are ignored. */
  setLabels(labels: Int32Array): void {
    const { geometry } = this.mesh;
    const positions = geometry.getAttribute('position') as BufferAttribute | undefined;
    if (!positions || positions.count !== 3 * labels.length) return;
    paintFaces(geometry, labels);
    // Found when first needed, and not in the same breath as the triangles.
    this.edges ??= new PartBorders(this.faces);
    this.drawBorders(this.edges.lines(labels, positions.array as Float32Array));
  }

  private drawBorders(lines: Float32Array): void {
    this.borders.geometry.dispose();
    this.borders.geometry = new BufferGeometry();
    this.borders.geometry.setAttribute('position', new BufferAttribute(lines, 3));
    this.redraw.request();
  }

  set hatched(hatched: boolean) {
    this.material.hatched = hatched;
    this.redraw.request();
  }

  /** Turns the model slowly until it is grabbed or told to rest. */
  turn(): void {
    if (this.turning) return;
    this.turning = true;
    this.lastTurn = performance.now();
    requestAnimationFrame(this.turnStep);
  }

  rest(): void {
    this.turning = false;
  }

  private readonly turnStep = (now: number): void => {
    if (!this.turning) return;
    requestAnimationFrame(this.turnStep);
    if (now - this.lastTurn < turnInterval) return;
    // After a pause, as when the page was in the background, it goes on where it was.
    const seconds = Math.min(now - this.lastTurn, 100) / 1000;
    this.lastTurn = now;
    this.orbit.turn(turnSpeed * seconds);
  };

  private resize(): void {
    const { clientWidth, clientHeight } = this.canvas;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, mostDense));
    this.renderer.setSize(clientWidth, clientHeight, false);
    this.orbit.fit(clientWidth / clientHeight);
    // A resized canvas is empty: waiting for the next frame would flash.
    this.draw();
  }

  private draw(): void {
    if (this.canvas.clientWidth > 0) this.renderer.render(this.scene, this.camera);
  }
}
