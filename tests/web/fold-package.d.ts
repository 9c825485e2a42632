/** The part of the FOLD format's own package that the tests use; it comes without types. */
declare module 'fold' {
  interface Fold {
    vertices_coords: number[][];
    vertices_vertices?: number[][];
    edges_vertices: number[][];
    edges_assignment: (string | null)[];
    edges_foldAngle: (number | null)[];
    edges_faces?: (number | null)[][];
    faces_vertices: number[][];
  }

  export const geom: {
    EPS: number;
    dist(a: number[], b: number[]): number;
    polygonOrientation(points: number[][]): number;
    segmentsCross(a: number[][], b: number[][]): boolean;
  };
  export const filter: {
    numVertices(fold: Fold): number;
    numEdges(fold: Fold): number;
    numFaces(fold: Fold): number;
    /** These change the fold that they are given. */
    removeLoopEdges(fold: Fold): void;
    removeDuplicateEdges_vertices(fold: Fold): void;
  };
  export const convert: {
    edges_vertices_to_faces_vertices(fold: Fold): Fold;
    faces_vertices_to_edges(fold: Pick<Fold, 'faces_vertices'>): Fold;
  };
}
