import type { Painted } from './model-message.js';

/** A place of a picture, from -1 to 1 to the right and up. */
interface Place {
  x: number;
  y: number;
}

/** What a brush paints on. */
export interface Canvas {
  /** The face that is seen at a place; -1 for none. */
  faceAt(x: number, y: number): number;
  /** The part of a face. */
  partOf(face: number): number;
  /** Gives a face to a part. */
  paint(face: number, part: number): void;
}

/** A hand may be quicker than its events: between two of them faces are looked for at so many places at most. */
const mostSteps = 12;

/** A step that leaves out no face that can be seen well, as a share of the picture. */
const step = 0.02;

/** Pulls the colour of one part over faces of others, stroke by stroke. */
export class Brush {
  private part = -1;
  private readonly faces = new Set<number>();
  private last: Place = { x: 0, y: 0 };

  constructor(private readonly canvas: Canvas) {}

  /** Whether a stroke is being made. */
  get isDown(): boolean {
    return this.part >= 0;
  }

  /** Begins with the colour that is seen at a place; not where there is none. */
  begin({ x, y }: Place): void {
    const face = this.canvas.faceAt(x, y);
    this.part = face < 0 ? -1 : this.canvas.partOf(face);
    this.faces.clear();
    this.last = { x, y };
  }

  /** Goes on to a place. */
  move({ x, y }: Place): void {
    const { canvas, last, faces, part } = this;
    const way = Math.hypot(x - last.x, y - last.y);
    const steps = Math.min(mostSteps, Math.max(1, Math.ceil(way / step)));
    for (let i = 1; i <= steps; ++i) {
      const share = i / steps;
      const face = canvas.faceAt(last.x + share * (x - last.x), last.y + share * (y - last.y));
      if (face < 0 || canvas.partOf(face) === part) continue;
      faces.add(face);
      canvas.paint(face, part);
    }
    this.last = { x, y };
  }

  /** Ends the stroke; null if it painted nothing. */
  end(): Painted | null {
    const painted = { faces: [...this.faces], part: this.part };
    this.part = -1;
    return painted.faces.length > 0 ? painted : null;
  }
}
