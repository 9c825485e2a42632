import { BufferAttribute, BufferGeometry, DoubleSide, Mesh, MeshBasicMaterial } from 'three';

/** A veil of the colour in which things are lit on the sheets, over faces of a model. */
const colour = '#ad381e';
const strength = 0.42;

/** Faces of a model that are lit, however the model looks beneath. */
export class LitFaces {
  readonly mesh = new Mesh(
    new BufferGeometry(),
    new MeshBasicMaterial({
      color: colour,
      transparent: true,
      opacity: strength,
      side: DoubleSide,
      // They lie in the faces themselves, and are drawn over them.
      depthWrite: false,
      polygonOffset: true,
      polygonOffsetFactor: -1,
      polygonOffsetUnits: -1,
    }),
  );

  constructor() {
    // It is always in view, and in other places with every frame of a folding.
    this.mesh.frustumCulled = false;
  }

  /** Takes the corners of another model, 3 per face; none of its faces are lit. */
  take(position: BufferAttribute): void {
    this.mesh.geometry.dispose();
    this.mesh.geometry = new BufferGeometry();
    this.mesh.geometry.setAttribute('position', position);
    this.light(new Int32Array());
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
  }

  /** Lights faces in place of those before; those that the model does not have are ignored. */
  light(faces: Int32Array): void {
    const { geometry } = this.mesh;
    const count = (geometry.getAttribute('position')?.count ?? 0) / 3;
    const known = faces.filter((face) => face >= 0 && face < count);
    const corners = Uint32Array.from({ length: 3 * known.length }, (_, at) => {
      return 3 * known[Math.floor(at / 3)]! + (at % 3);
    });
    geometry.setIndex(new BufferAttribute(corners, 1));
    this.mesh.visible = known.length > 0;
  }
}
