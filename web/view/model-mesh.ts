import {
  BufferAttribute,
  BufferGeometry,
  Group,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  type Raycaster,
} from 'three';
import { EdgeLines, nextCorner } from './edge-lines.js';
import { addPaint, paintFaces } from './face-paint.js';
import { HatchMaterial } from './hatch-material.js';
import { LitFaces } from './lit-faces.js';
import type { Corners } from './looked-mesh.js';
import { flatMesh } from './model-geometry.js';

/** Lines along borders and cuts. */
const ink = '#232a31';

/** Of faces that are seen through: two of them in front of a third leave enough of it. */
const glassOpacity = 0.4;

/** The faces of a model and the lines between its parts, in the hands of the graphics card. */
export class ModelMesh {
  readonly group = new Group();
  private readonly material = new HatchMaterial();
  private readonly mesh = new Mesh(new BufferGeometry(), this.material);
  private readonly lines = new LineSegments(
    new BufferGeometry(),
    new LineBasicMaterial({ color: ink }),
  );
  private readonly lit = new LitFaces();
  private position = new BufferAttribute(new Float32Array(), 3);
  private normal = new BufferAttribute(new Float32Array(), 3);
  /** Corners at which the lines start and end: as many as there may ever be. */
  private ends = new BufferAttribute(new Uint32Array(), 1);
  private faces: Int32Array = new Int32Array();
  private edges: EdgeLines | null = null;
  private labels: Int32Array = new Int32Array();
  private selected: ReadonlySet<number> = new Set();

  constructor() {
    // They are always in view, and in other places with every frame of a folding.
    this.mesh.frustumCulled = this.lines.frustumCulled = false;
    this.group.add(this.mesh, this.lines, this.lit.mesh);
  }

  /** 3 per corner of the faces; those who write into it call `moved`. */
  get positions(): Float32Array {
    return this.position.array as Float32Array;
  }

  /** 3 per corner of the faces; those who write into it call `moved`. */
  get normals(): Float32Array {
    return this.normal.array as Float32Array;
  }

  /** For others who draw the same faces. */
  get corners(): Corners {
    return { position: this.position, normal: this.normal };
  }

  /** Whether faces and lines are drawn; faces that are not can be pointed at all the same. */
  draws({ faces, lines }: { faces: boolean; lines: boolean }): void {
    this.mesh.visible = faces;
    this.lines.visible = lines;
  }

  set hatched(hatched: boolean) {
    this.material.hatched = hatched;
  }

  /** Lets what lies inside be seen through the faces. */
  set glass(glass: boolean) {
    this.material.transparent = glass;
    this.material.opacity = glass ? glassOpacity : 1;
    this.material.depthWrite = !glass;
    this.material.needsUpdate = true;
  }

  /** Takes another model, as blank paper. 3 numbers per vertex and face. */
  show(vertices: Float32Array | Float64Array, faces: Int32Array): void {
    const { positions, normals, uvs } = flatMesh(vertices, faces);
    this.faces = faces;
    this.edges = null;
    this.position = new BufferAttribute(positions, 3);
    this.normal = new BufferAttribute(normals, 3);
    // Every edge has two sides, and each of them two ends.
    this.ends = new BufferAttribute(new Uint32Array(2 * faces.length), 1);
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', this.position);
    geometry.setAttribute('normal', this.normal);
    geometry.setAttribute('uv', new BufferAttribute(uvs, 2));
    addPaint(geometry, faces.length / 3);
    this.selected = new Set();
    this.labels = new Int32Array(faces.length / 3).fill(-1);
    paintFaces(geometry, this.labels, this.selected);
    const lines = new BufferGeometry();
    lines.setAttribute('position', this.position);
    lines.setIndex(this.ends);
    lines.setDrawRange(0, 0);
    // Both at once: they share their corners.
    this.mesh.geometry.dispose();
    this.lines.geometry.dispose();
    this.mesh.geometry = geometry;
    this.lines.geometry = lines;
    this.lit.take(this.position);
  }

  /** Colours the faces by their parts. Those of another model are ignored. */
  paint(labels: Int32Array): void {
    if (3 * labels.length !== this.faces.length) return;
    this.labels = labels;
    paintFaces(this.mesh.geometry, labels, this.selected);
    this.lineBorders();
  }

  /** Lets parts stand out by fading all others, unless there are none. */
  select(parts: readonly number[]): void {
    this.selected = new Set(parts);
    paintFaces(this.mesh.geometry, this.labels, this.selected);
  }

  /** Lights faces, in place of those that were lit before. */
  light(faces: Int32Array): void {
    this.lit.light(faces);
  }

  /** The face that a ray meets first; -1 if it meets none that belongs to a part. */
  faceAlong(ray: Raycaster): number {
    // The faces may have moved since the last time.
    this.mesh.geometry.computeBoundingSphere();
    const face = ray.intersectObject(this.mesh)[0]?.faceIndex ?? -1;
    return this.partOf(face) >= 0 ? face : -1;
  }

  /** The part of a face; -1 for none. */
  partOf(face: number): number {
    return this.labels[face] ?? -1;
  }

  /** Gives a face to a part, until the faces are coloured anew. */
  give(face: number, part: number): void {
    this.paint(this.labels.map((own, other) => (other === face ? part : own)));
  }

  /** Draws lines along the borders of the parts. */
  lineBorders(): void {
    const part = (corner: number): number => this.labels[Math.floor(corner / 3)]!;
    this.line((a, b) => part(a) !== part(b));
  }

  /**
   * Draws lines along all cuts.
   *
   * @param vertices of the nets, per corner of the faces: those of a cut's two sides differ
   */
  lineCuts(vertices: Int32Array): void {
    const differ = (a: number, b: number): boolean => vertices[a] !== vertices[nextCorner(b)];
    this.line((a, b) => differ(a, b) || differ(b, a));
  }

  private line(wanted: (a: number, b: number) => boolean): void {
    this.edges ??= new EdgeLines(this.faces);
    const ends = this.edges.along(wanted);
    this.ends.array.set(ends);
    this.ends.needsUpdate = true;
    this.lines.geometry.setDrawRange(0, ends.length);
  }

  /** Frees what the graphics card has of it. */
  dispose(): void {
    for (const { geometry, material } of [this.mesh, this.lines]) {
      geometry.dispose();
      material.dispose();
    }
    this.lit.dispose();
  }

  /** Says that positions and normals have changed. */
  moved(): void {
    this.position.needsUpdate = this.normal.needsUpdate = true;
  }
}
