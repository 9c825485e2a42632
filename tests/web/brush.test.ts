import { describe, expect, it } from 'vitest';
import { Brush } from '../../web/view/brush.js';

/** Five faces side by side from -1 to 1, below 0 nothing; the first two are of part 7, the others of 3. */
class Row {
  readonly labels = [7, 7, 3, 3, 3];
  readonly brush = new Brush({
    faceAt: (x, y) => (y < 0 ? -1 : Math.min(4, Math.floor((x + 1) * 2.5))),
    partOf: (face) => this.labels[face]!,
    paint: (face, part) => (this.labels[face] = part),
  });
}

const at = (x: number, y = 0) => ({ x, y });

describe('a brush', () => {
  it('pulls the colour where it begins over the faces on its way, and tells them at the end', () => {
    const { brush, labels } = new Row();
    brush.begin(at(-0.9));
    expect(brush.isDown).toBe(true);
    brush.move(at(-0.3));
    expect(labels).toEqual([7, 7, 3, 3, 3]);
    // A quick hand leaves nothing out.
    brush.move(at(0.5));
    expect(labels).toEqual([7, 7, 7, 7, 3]);
    // Back over the same faces paints them once.
    brush.move(at(0));
    expect(brush.end()).toEqual({ part: 7, faces: [2, 3] });
    expect(brush.isDown).toBe(false);
  });

  it('paints nothing where it begins beside the model, or stays on one part', () => {
    const { brush, labels } = new Row();
    brush.begin(at(0, -1));
    expect(brush.isDown).toBe(false);
    brush.begin(at(-0.9));
    brush.move(at(-0.5));
    expect(brush.end()).toBeNull();
    expect(labels).toEqual([7, 7, 3, 3, 3]);
  });

  it('passes over what is beside the model', () => {
    const { brush, labels } = new Row();
    brush.begin(at(0.9));
    brush.move(at(0.9, -0.5));
    brush.move(at(-0.9, -0.5));
    brush.move(at(-0.9));
    expect(brush.end()).toEqual({ part: 3, faces: [0] });
    expect(labels).toEqual([3, 7, 3, 3, 3]);
  });
});
