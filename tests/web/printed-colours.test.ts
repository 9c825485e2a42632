/** Sheets whose pieces are printed in colours, in every format. */
import UPNG from '@pdf-lib/upng';
import { XMLParser } from 'fast-xml-parser';
import { describe, expect, it } from 'vitest';
import { writeDxf } from '../../web/export/dxf.js';
import { writePdf } from '../../web/export/pdf.js';
import { writePng } from '../../web/export/png.js';
import { writeSvg } from '../../web/export/svg.js';
import type { JobResult } from '../../web/model/job.js';
import type { Machine, PrintOptions } from '../../web/model/print-options.js';
import { boxAndLidResult, cubeResult } from './fixtures.js';
import { colouredCube, picturedCube, sideColours } from './looked-cube.js';
import { readPdf } from './pdf-file.js';
import { printOf } from './printed.js';

interface Element {
  'data-piece': string;
  fill: string;
  stroke?: string;
  'stroke-width'?: string;
  'paint-order'?: string;
}

interface ImageElement {
  'data-piece': string;
  x: string;
  y: string;
  width: string;
  height: string;
  'xlink:href': string;
}

interface Group {
  id: string;
  image?: ImageElement[];
  path?: Element[];
  text?: Element[];
}

function groupsOf(svg: string): Map<string, Group> {
  const parser = new XMLParser({
    ignoreAttributes: false,
    attributeNamePrefix: '',
    isArray: (name) => ['g', 'path', 'text', 'image'].includes(name),
  });
  const { g } = (parser.parse(svg) as { svg: { g: Group[] } }).svg;
  return new Map(g.map((group) => [group.id, group]));
}

async function drawn(
  result: JobResult,
  options: Partial<PrintOptions> = {},
): Promise<Map<string, Group>> {
  return groupsOf(writeSvg(await printOf(result, { options: { dpi: 100, ...options } }), 0));
}

async function noticesOf(result: JobResult, options: Partial<PrintOptions>): Promise<string[]> {
  return (await printOf(result, { options })).notices.map(({ code }) => code);
}

interface Decoded {
  width: number;
  height: number;
  rgba: Uint8Array;
}

function decoded(png: Uint8Array): Decoded {
  const image = UPNG.decode(png.slice().buffer);
  const [rgba] = UPNG.toRGBA8(image);
  return { width: image.width, height: image.height, rgba: new Uint8Array(rgba!) };
}

function imageIn({ 'xlink:href': address }: ImageElement): Decoded {
  const [head, data] = address.split(',') as [string, string];
  expect(head).toBe('data:image/png;base64');
  return decoded(new Uint8Array(Buffer.from(data, 'base64')));
}

/** The cube of six colours as a box and its lid, on two sheets. */
function colouredBox(): JobResult {
  return { ...boxAndLidResult(), looks: colouredCube().looks! };
}

/** The colour of a PNG sheet at a place; mm from the lower left. */
function colourAt(sheet: Decoded, dpi: number, x: number, y: number): number[] {
  const [column, row] = [x, 297 - y].map((at) => Math.floor((at / 25.4) * dpi));
  const at = 4 * (row! * sheet.width + column!);
  return [...sheet.rgba.subarray(at, at + 3)];
}

describe('pieces in the colours of the model', () => {
  it('are one image for each piece and sheet, below all else', async () => {
    const print = await printOf(colouredBox(), { options: { dpi: 150 } });
    const { pieces } = colouredBox();
    for (const [sheet, { name, x, y }] of pieces.entries()) {
      const groups = groupsOf(writeSvg(print, sheet));
      expect([...groups.keys()][0]).toBe('texture');
      const { image } = groups.get('texture')!;
      expect(image!.map((element) => element['data-piece'])).toEqual([name]);
      const { width, height } = imageIn(image![0]!);
      // Of the resolution that was asked for, around the piece.
      const [left, top, across, down] = (['x', 'y', 'width', 'height'] as const).map((key) =>
        Number(image![0]![key]),
      ) as [number, number, number, number];
      expect((across / width) * 150).toBeCloseTo(25.4, 1);
      expect((down / height) * 150).toBeCloseTo(25.4, 1);
      expect(left).toBeLessThan(x - 0.5);
      expect(297 - top - down).toBeLessThan(y - 0.5);
      expect(left).toBeGreaterThan(x - 2);
    }
  });

  it('have the same colours in PDF files, in the lowest layer', async () => {
    const print = await printOf(colouredBox(), { options: { dpi: 150 } });
    const { layers, pages } = await readPdf(await writePdf(print));
    expect(layers[0]).toBe('Textures');
    for (const [sheet, { images }] of pages.entries()) {
      expect(images.map(({ layer }) => layer)).toEqual(['Textures']);
      const [image] = images;
      const [element] = groupsOf(writeSvg(print, sheet)).get('texture')!.image!;
      const { rgba, width, height } = imageIn(element!);
      expect([image!.width, image!.height]).toEqual([width, height]);
      expect(image!.left).toBeCloseTo(Number(element!.x), 3);
      expect(image!.top).toBeCloseTo(297 - Number(element!.y), 3);
      let wrong = 0;
      for (let dot = 0; dot < rgba.length; dot += 4) {
        const isThere = rgba[dot + 3] === 255;
        if (image!.rgba[dot + 3]! > 0 !== isThere) ++wrong;
        else if (isThere && [0, 1, 2].some((i) => rgba[dot + i] !== image!.rgba[dot + i])) ++wrong;
      }
      expect(wrong).toBe(0);
    }
  });

  it('lie where their lines are on PNG sheets', async () => {
    const result = colouredCube();
    const piece = result.pieces[0]!;
    const dpi = 100;
    const options = { dpi, legend: false, lines: { cut: { width: 0.01 } } };
    const sheet = decoded(await writePng(await printOf(result, { options }), 0));
    for (let face = 0; face < 12; ++face) {
      const [x, y] = [0, 1].map((axis) => {
        const corners = [0, 1, 2].map(
          (i) => piece.vertices[2 * piece.faces[3 * face + i]! + axis]!,
        );
        // Nearer to the first corner, where no name and no number stands.
        return 0.7 * corners[0]! + 0.15 * corners[1]! + 0.15 * corners[2]!;
      }) as [number, number];
      const colour = colourAt(sheet, dpi, piece.x + x, piece.y + y);
      expect(colour).toEqual(sideColours[piece.sources[face]! >> 1]);
    }
  });

  it('give the same bytes every time', async () => {
    const once = async (): Promise<Uint8Array> => writePdf(await printOf(picturedCube()));
    expect(Buffer.compare(await once(), await once())).toBe(0);
  });

  it('have lines and letters with light rims', async () => {
    const groups = await drawn(colouredCube());
    const rims = groups.get('texture')!.path!;
    expect(rims.map(({ stroke }) => stroke)).toEqual(rims.map(() => '#ffffff'));
    // Mountain folds and cuts; the cube has no valleys.
    expect(rims.map((rim) => Number(rim['stroke-width']))).toEqual([0.34, 0.41]);
    for (const text of groups.get('id')!.text!) expect(text['paint-order']).toBe('stroke');
    for (const text of (await drawn(cubeResult())).get('id')!.text!) {
      expect(text['paint-order']).toBeUndefined();
    }
  });

  it('stretch with the lines when a printer is corrected', async () => {
    const image = async (options: Partial<PrintOptions>): Promise<ImageElement> =>
      (await drawn(colouredCube(), options)).get('texture')!.image![0]!;
    const [plain, corrected] = [await image({}), await image({ measured: [48, 50] })];
    expect(Number(corrected.width)).toBeCloseTo((Number(plain.width) * 50) / 48, 3);
    expect(corrected.height).toBe(plain.height);
    expect(corrected['xlink:href']).toBe(plain['xlink:href']);
  });

  it('are printed where there are some, unless they are switched off', async () => {
    expect((await drawn(colouredCube(), { texture: 'off' })).has('texture')).toBe(false);
    expect((await drawn(cubeResult())).has('texture')).toBe(false);
    expect(await noticesOf(cubeResult(), { texture: 'on' })).toEqual(['no-looks']);
    expect(await noticesOf(cubeResult(), { texture: 'auto' })).toEqual([]);
    expect(await noticesOf(colouredCube(), { texture: 'on' })).toEqual([]);
  });

  it('are printed with what can be had when a picture cannot, which is told', async () => {
    const result = picturedCube();
    result.looks!.pictures = [{ name: 'a.tga', bytes: new Uint8Array(30) }];
    const print = await printOf(result, { options: { dpi: 72 } });
    expect(print.notices).toEqual([
      { code: 'pictures-unreadable', params: { what: 'format', files: ['a.tga'] } },
    ]);
    expect(writeSvg(print, 0)).toContain('<image');
  });

  it('leave as much of flaps to be filled as they do not cover', async () => {
    const flapAreas = async (options: Partial<PrintOptions>): Promise<number> => {
      const result = colouredCube();
      const piece = result.pieces[0]!;
      const edge = piece.assignments.indexOf('B');
      piece.flaps = {
        edges: Int32Array.of(edge),
        bases: piece.edges.slice(2 * edge, 2 * edge + 2),
        corners: Float64Array.of(0, 0, 2, -4, 8, -4, 10, 0),
        angles: Float64Array.of(90),
      };
      const { sheets } = await printOf(result, { options: { dpi: 72, ...options } });
      const walks = sheets[0]!.pieces[0]!.flaps;
      return walks.reduce((sum, walk) => {
        const heights = walk.map(([, y]) => y);
        return sum + Math.max(...heights) - Math.min(...heights);
      }, 0);
    };
    expect(await flapAreas({ texture: 'off' })).toBeCloseTo(4);
    expect(await flapAreas({ flapBleed: 'none' })).toBeCloseTo(3.5);
    expect(await flapAreas({ flapBleed: 'half' })).toBeCloseTo(1.5);
    expect(await flapAreas({ flapBleed: 'whole' })).toBe(0);
  });

  it.each([
    ['silhouette', true],
    ['cricut', false],
    ['generic', false],
  ] as const)('go to machines that print and cut: %s', async (machine: Machine, isPrinted) => {
    const groups = await drawn(colouredCube(), { machine, texture: 'on', colour: 'part' });
    expect(groups.get('texture')?.image?.length ?? 0).toBe(isPrinted ? 1 : 0);
    // A machine would cut along anything else.
    expect(groups.get('texture')?.path).toBeUndefined();
    expect(JSON.stringify([...groups.values()])).not.toContain('#ffffff');
  });

  it('are in no DXF file', async () => {
    const options = { legend: false };
    const dxf = await writeDxf(await printOf(colouredCube(), { options }), 0);
    expect(dxf).toBe(await writeDxf(await printOf(cubeResult(), { options }), 0));
  });
});

describe('pieces in the colours of their parts', () => {
  it('are areas with an edge that goes half a millimetre beyond cuts', async () => {
    const { path, image } = (await drawn(cubeResult(), { colour: 'part' })).get('texture')!;
    expect(image).toBeUndefined();
    const [area, edge] = path!;
    expect(path).toHaveLength(2);
    expect(area!.fill).toMatch(/^#[0-9a-f]{6}$/);
    expect([edge!.stroke, edge!['stroke-width']]).toEqual([area!.fill, '1']);
  });

  it('give way to those of the model only where these are asked for', async () => {
    const both = await drawn(colouredCube(), { colour: 'part', texture: 'on' });
    expect(both).toEqual(await drawn(colouredCube()));
    const parts = await drawn(cubeResult(), { colour: 'part' });
    for (const texture of ['auto', 'off'] as const) {
      expect(await drawn(colouredCube(), { colour: 'part', texture })).toEqual(parts);
    }
    expect(await drawn(cubeResult(), { colour: 'part', texture: 'on' })).toEqual(parts);
  });

  it('are in PDF files, too', async () => {
    const print = await printOf(boxAndLidResult(), { options: { colour: 'part' } });
    const { layers, pages } = await readPdf(await writePdf(print));
    expect(layers[0]).toBe('Textures');
    const [one, other] = pages.map(({ paths }) => paths[0]!.colour);
    expect(one).not.toBe(other);
  });
});
