/** The files that readers write for the engine. */
import { describe, expect, it } from 'vitest';
import { engineFile } from '../../web/read/engine-file.js';
import { identity, scaling } from '../../web/read/matrix.js';
import { Soup, type PartLooks } from '../../web/read/soup.js';
import { trianglesOf } from './read-model.js';

const positions = [0, 0, 0, 1, 0, 0, 0, 1, 0];
const triangles = [0, 1, 2];

const looks: PartLooks = {
  places: Float32Array.of(0, 0, 0.1, -7.25, NaN, NaN),
  colours: Uint8Array.of(255, 0, 0, 0, 255, 0, 1, 2, 3),
  materials: Int32Array.of(4),
};

function soupOf(error: number, ...all: (Partial<PartLooks> | undefined)[]): Soup {
  const soup = new Soup();
  for (const each of all) {
    const none = { places: null, colours: null, materials: null };
    soup.add(
      { positions, triangles, error, ...(each && { looks: { ...none, ...each } }) },
      identity,
    );
  }
  return soup;
}

const headerOf = ({ bytes }: { bytes: Uint8Array }): string =>
  new TextDecoder('latin1').decode(bytes).split('end_header')[0]!;

describe('a file for the engine', () => {
  it.each([
    ['floats', 2 ** -25, 'binary_little_endian'],
    ['text', 0.001, 'ascii'],
  ])('has the looks of all parts, as %s', (_, error, format) => {
    const file = engineFile(soupOf(error, looks, undefined, { materials: Int32Array.of(0) }));
    expect([file.name, headerOf(file)]).toEqual(['model.ply', expect.stringContaining(format)]);
    const none = [NaN, NaN, NaN, NaN, NaN, NaN];
    const white = new Array<number>(9).fill(255);
    const found = trianglesOf(file);
    expect(found.places.map(Math.fround)).toEqual([...looks.places!, ...none, ...none]);
    expect(found.colours).toEqual([...looks.colours!, ...white, ...white]);
    expect(found.materials).toEqual([4, -1, 0]);
    expect(found.corners).toEqual([0, 1, 2, 3, 4, 5, 6, 7, 8]);
    expect(found.positions).toEqual([...positions, ...positions, ...positions]);
  });

  it('says nothing of looks that no part has', () => {
    const file = engineFile(soupOf(0.001, undefined));
    expect(headerOf(file)).not.toMatch(/ (?:s|t|red|material)\n/);
    const header = headerOf(engineFile(soupOf(0.001, { colours: looks.colours! })));
    expect(header).toContain('uchar red');
    expect(header).not.toMatch(/ (?:s|t|material)\n/);
  });

  it('keeps looks with their corners where a part is mirrored', () => {
    const soup = new Soup();
    soup.add({ positions, triangles, error: 0, looks }, scaling(-1));
    const found = trianglesOf(engineFile(soup));
    expect(found.corners).toEqual([0, 2, 1]);
    expect(found.colours).toEqual([...looks.colours!]);
  });
});
