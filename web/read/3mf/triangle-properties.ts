/** A property of each corner of a triangle: numbers in a group; -1 for none. */
export interface TriangleProperty {
  group: number;
  corners: readonly [number, number, number];
}

/** Properties of the triangles of a mesh. Nothing is kept for meshes without any. */
export class TriangleProperties {
  private readonly groups: number[] = [];
  /** 3 per triangle. */
  private readonly corners: number[] = [];

  set(triangle: number, { group, corners }: TriangleProperty): void {
    while (this.groups.length < triangle) {
      this.groups.push(-1);
      this.corners.push(-1, -1, -1);
    }
    this.groups.push(group);
    this.corners.push(...corners);
  }

  get isEmpty(): boolean {
    return this.groups.length === 0;
  }

  group(triangle: number): number {
    return this.groups[triangle] ?? -1;
  }

  corner(triangle: number, corner: number): number {
    return this.corners[3 * triangle + corner] ?? -1;
  }
}
