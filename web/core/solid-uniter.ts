/** Unites bodies by Manifold, a library of exact booleans on triangle meshes. */
import Module, { type Manifold, type ManifoldToplevel } from 'manifold-3d';
import type { Solid, SolidUniter, UnitedSolids } from '../model/solids.js';

/** Sorts floats into a map by their places: what the library rounds is found again by it. */
class Exact {
  private readonly points = new Map<string, [number, number, number]>();

  add(positions: Float64Array): void {
    for (let i = 0; i < positions.length; i += 3) {
      const [x, y, z] = [positions[i]!, positions[i + 1]!, positions[i + 2]!];
      this.points.set(this.key(x, y, z), [x, y, z]);
    }
  }

  at(x: number, y: number, z: number): [number, number, number] {
    return this.points.get(this.key(x, y, z)) ?? [x, y, z];
  }

  private key(x: number, y: number, z: number): string {
    // Adding 0 makes one of both zeros.
    return `${Math.fround(x) + 0} ${Math.fround(y) + 0} ${Math.fround(z) + 0}`;
  }
}

/** A solid in the library, which takes single floats in and then the exact places of its vertices. */
function imported(
  { Manifold, Mesh }: ManifoldToplevel,
  { positions, faces }: Solid,
  firstFace: number,
): Manifold {
  const mesh = new Mesh({
    numProp: 3,
    vertProperties: Float32Array.from(positions),
    triVerts: Uint32Array.from(faces),
    // Faces of different numbers are kept apart, also where they are coplanar.
    faceID: Uint32Array.from({ length: faces.length / 3 }, (_, face) => firstFace + face),
    runIndex: Uint32Array.of(0, faces.length),
    runOriginalID: Uint32Array.of(Manifold.reserveIDs(1)),
  });
  const single = new Manifold(mesh);
  const exact = new Exact();
  exact.add(positions);
  const double = single.warpBatch((vertices, count) => {
    for (let i = 0; i < 3 * count; i += 3) {
      vertices.set(exact.at(vertices[i]!, vertices[i + 1]!, vertices[i + 2]!), i);
    }
  });
  single.delete();
  return double;
}

/** What the library has come to, with places as exact as it has them itself. */
function exported(united: Manifold): UnitedSolids {
  const exact = new Exact();
  const read = united.warpBatch((vertices, count) => {
    exact.add(Float64Array.from(vertices.subarray(0, 3 * count)));
  });
  const mesh = united.getMesh();
  read.delete();
  const positions = new Float64Array(mesh.vertProperties.length);
  for (let i = 0; i < positions.length; i += 3) {
    const [x, y, z] = mesh.vertProperties.subarray(i, i + 3);
    positions.set(exact.at(x!, y!, z!), i);
  }
  return {
    positions,
    faces: Int32Array.from(mesh.triVerts),
    sources: Int32Array.from(mesh.faceID),
  };
}

function unite(library: ManifoldToplevel, solids: readonly Solid[]): UnitedSolids | null {
  const parts: Manifold[] = [];
  let united: Manifold | null = null;
  try {
    let firstFace = 0;
    for (const solid of solids) {
      parts.push(imported(library, solid, firstFace));
      firstFace += solid.faces.length / 3;
    }
    united = library.Manifold.union(parts);
    return united.isEmpty() ? null : exported(united);
  } catch {
    // Of what is no solid to it.
    return null;
  } finally {
    for (const part of parts) part.delete();
    united?.delete();
  }
}

/** @param wasm of the library */
export async function makeUniter(wasm: Uint8Array): Promise<SolidUniter> {
  // Where it lies does not matter, but it is asked for in any case.
  const library = await Module({ wasmBinary: wasm, locateFile: () => '' } as object as {
    locateFile: () => string;
  });
  library.setup();
  return (solids) => unite(library, solids);
}
