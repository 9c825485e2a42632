import { describe, expect, it } from 'vitest';
import { readMtl, type MtlMaterial } from '../../web/read/mtl.js';

const encode = (text: string): Uint8Array => new TextEncoder().encode(text);

const read = (text: string): MtlMaterial[] => readMtl(encode(text));

/** The picture of a material with one line. */
const picture = (line: string): MtlMaterial['picture'] => read(`newmtl a\n${line}`)[0]!.picture;

describe('materials of an MTL file', () => {
  it('have names with blanks and a colour, whatever the case and the line ends', () => {
    const text =
      '# made by hand\r\nnewmtl  Red, shiny \r\n\tKd 1 0.5 0\r\nillum 2\rNEWMTL b\rkD 0.2';
    expect(read(text)).toEqual([
      { name: 'Red, shiny', colour: [255, 128, 0], picture: null },
      { name: 'b', colour: [51, 51, 51], picture: null },
    ]);
  });

  it('have no colour that is given as a spectrum, or is no number; others stay in their range', () => {
    const text = 'newmtl a\nKd spectral a.rfl\nnewmtl b\nKd xyz 1 1 1\nnewmtl c\nKd 7 -1 nan';
    expect(read(text).map(({ colour }) => colour)).toEqual([null, null, [255, 0, 0]]);
  });

  it('have the path of a picture as it stands there', () => {
    for (const path of [
      'wood grain.png',
      '.\\textures\\a.png',
      'C:\\Users\\someone\\a b.png',
      '-.png',
    ]) {
      expect(picture(`map_Kd\t${path}  `)?.path).toBe(path);
    }
    expect(picture('map_Kd "a b.png"')?.path).toBe('a b.png');
    expect(picture('map_Kd long \\\nname.png')?.path).toBe('long  name.png');
  });

  it('have options before it', () => {
    expect(picture('map_Kd -s 2 3 1 -o 0.5 -clamp on -mm 0 1 -bm 2 a b.png')).toEqual({
      path: 'a b.png',
      wrap: 'clamp',
      scale: [2, 3],
      offset: [0.5, 0],
    });
    expect(picture('map_Kd -blendu off -clamp off -s 1 1 1 2.png')).toEqual({
      path: '2.png',
      wrap: 'repeat',
      scale: [1, 1],
      offset: [0, 0],
    });
    expect(picture('map_Kd -s 1 2')?.path).toBe('2');
    expect(picture('map_Kd -clamp')?.path).toBeUndefined();
  });

  it("keep their first colour and picture, and what stands before all of them is no one's", () => {
    const text = 'Kd 1 1 1\nmap_Kd x.png\nnewmtl a\nKd 0 0 0\nKd 1 1 1\nmap_Kd a.png\nmap_Kd b.png';
    expect(read(text)).toMatchObject([{ colour: [0, 0, 0], picture: { path: 'a.png' } }]);
  });
});

describe('files that are no MTL files', () => {
  it('have no materials', () => {
    expect(readMtl(new Uint8Array())).toEqual([]);
    expect(readMtl(Uint8Array.from({ length: 5000 }, (_, i) => (i * 7919) % 256))).toEqual([]);
    expect(readMtl(new Uint8Array(2 ** 24 + 1))).toEqual([]);
  });

  it('are read through in no time, whatever they are full of', () => {
    for (const text of ['-cc on ', ' ', 'newmtl\t', '\\\n', '"']) {
      const line = `newmtl a\nmap_Kd ${text.repeat(2 ** 20 / text.length)}\n`;
      expect(read(line).length).toBeLessThan(3);
    }
  });
});
