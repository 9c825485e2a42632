/** In mm. */
export type Point = [x: number, y: number];
export type Segment = [from: Point, to: Point];
