/** Materials, pictures and colours of 3MF packages, as their reader hands them over. */
import { describe, expect, it } from 'vitest';
import type { LookedTriangles } from './ply-file.js';
import { codesOf, read, trianglesOf } from './read-model.js';
import { png } from './tiny-pictures.js';
import { modelPart, threeMf, type Contents } from './zips.js';
import type { ReadModel } from '../../web/read/read-model.js';

const base =
  '<basematerials id="1"><base name="Red" displaycolor="#FF0000"/>' +
  '<base name="Half" displaycolor="#00ff0080"/></basematerials>';
const colours =
  '<m:colorgroup id="2"><m:color color="#102030"/><m:color color="#405060FF"/></m:colorgroup>';
const picture =
  '<m:texture2d id="3" path="/3D/Textures/my%20wood.png" contenttype="image/png" tilestyleu="mirror" tilestylev="none"/>' +
  '<m:texture2dgroup id="4" texid="3"><m:tex2coord u="0" v="0"/><m:tex2coord u="1" v="0"/>' +
  '<m:tex2coord u="0.5" v="2"/></m:texture2dgroup>';
const pictureFile = { '3D/Textures/my wood.png': png };

/** Two triangles that share an edge, each with attributes, of an object with attributes. */
function squareOf(one: string, other: string, object = ''): string {
  return (
    `<object id="9" ${object}><mesh><vertices><vertex x="0" y="0" z="0"/><vertex x="1" y="0" z="0"/>` +
    '<vertex x="1" y="1" z="0"/><vertex x="0" y="1" z="0"/></vertices><triangles>' +
    `<triangle v1="0" v2="1" v3="2" ${one}/><triangle v1="0" v2="2" v3="3" ${other}/></triangles></mesh></object>`
  );
}

const namespace =
  'xmlns:m="http://schemas.microsoft.com/3dmanufacturing/material/2015/02" requiredextensions="m"';

async function looked(
  resources: string,
  more: Contents = {},
): Promise<{ model: ReadModel; triangles: LookedTriangles }> {
  const part = modelPart(resources, '<item objectid="9"/>', namespace);
  const model = await read(threeMf(part, more));
  return { model, triangles: trianglesOf(model.file) };
}

describe('materials of 3MF', () => {
  it('are those of triangles, or else of their object', async () => {
    const square = squareOf('pid="1" p1="1"', '', 'pid="1" pindex="0"');
    const { model, triangles } = await looked(base + square);
    expect(model.looks?.materials.map(({ name, colour }) => [name, colour])).toEqual([
      ['Half', [0, 255, 0]],
      ['Red', [255, 0, 0]],
    ]);
    expect(triangles.materials).toEqual([0, 1]);
    expect(triangles.positions).toHaveLength(12);
    expect(model.notices).toEqual([]);
  });

  it('are of the object for a triangle that only says which of them', async () => {
    const { triangles, model } = await looked(base + squareOf('p1="1"', '', 'pid="1" pindex="0"'));
    expect(triangles.materials.map((i) => model.looks!.materials[i]!.name)).toEqual([
      'Half',
      'Red',
    ]);
  });

  it('are none for an object without', async () => {
    const { model, triangles } = await looked(base + squareOf('', ''));
    expect([triangles.materials, triangles.colours, triangles.places]).toEqual([[], [], []]);
    expect(model.looks?.materials).toEqual([]);
  });
});

describe('colours of 3MF', () => {
  it('are those of corners, at which vertices come apart', async () => {
    const { triangles } = await looked(
      colours + squareOf('pid="2" p1="0" p2="1" p3="0"', 'pid="2" p1="0"'),
    );
    const [first, second] = [
      [16, 32, 48],
      [64, 80, 96],
    ];
    const colourOf = (corner: number): number[] =>
      triangles.colours.slice(3 * triangles.corners[corner]!, 3 * triangles.corners[corner]! + 3);
    expect([0, 1, 2, 3, 4, 5].map(colourOf)).toEqual([first, second, first, first, first, first]);
    // The shared edge has the same colours on both sides.
    expect(triangles.positions).toHaveLength(12);
    const apart = await looked(colours + squareOf('pid="2" p1="1"', 'pid="2" p1="0"'));
    expect(apart.triangles.positions).toHaveLength(18);
  });
});

describe('pictures of 3MF', () => {
  it('lie where corners say, counted upwards', async () => {
    const { model, triangles } = await looked(
      picture + squareOf('pid="4" p1="0" p2="1" p3="2"', ''),
      pictureFile,
    );
    expect(triangles.materials).toEqual([0, -1]);
    expect(triangles.places.slice(0, 6)).toEqual([0, 0, 1, 0, 0.5, 2]);
    expect(triangles.places.slice(6).every(Number.isNaN)).toBe(true);
    expect(model.looks?.pictures).toEqual([{ name: '3D/Textures/my wood.png', bytes: png }]);
    expect(model.looks?.materials).toMatchObject([{ picture: 0, wrap: ['mirror', 'clamp'] }]);
  });

  it('are named where they are missing', async () => {
    const { model } = await looked(picture + squareOf('pid="4" p1="0"', ''));
    const params = { what: 'pictures', files: ['3D/Textures/my wood.png'] };
    expect(model.notices).toEqual([{ code: 'missing-looks', params }]);
  });
});

describe('mixtures and layers of 3MF', () => {
  it('become what there is most of, and the topmost picture; that is told', async () => {
    const mixed =
      '<m:compositematerials id="5" matid="1" matindices="0 1"><m:composite values="0.3 0.7"/></m:compositematerials>' +
      '<m:multiproperties id="6" pids="1 4 2"><m:multi pindices="0 1 0"/><m:multi pindices="1"/></m:multiproperties>';
    const { model, triangles } = await looked(
      base + colours + picture + mixed + squareOf('pid="5" p1="0"', 'pid="6" p1="0" p2="1" p3="0"'),
      pictureFile,
    );
    expect(triangles.materials.map((i) => model.looks!.materials[i]!.name)).toEqual([
      'Half',
      '3D/Textures/my wood.png',
    ]);
    expect(triangles.places.filter((value) => !Number.isNaN(value))).toEqual([1, 0, 0, 0, 1, 0]);
    expect(codesOf(model)).toEqual(['simplified-looks']);
  });
});

describe('damaged looks of 3MF', () => {
  it('leave triangles plain, and are told', async () => {
    for (const attributes of ['pid="7" p1="0"', 'pid="1" p1="9"', 'pid="6" p1="0"']) {
      const nested =
        '<m:multiproperties id="6" pids="6 7"><m:multi pindices="0 0"/></m:multiproperties>';
      const { model, triangles } = await looked(base + nested + squareOf(attributes, ''));
      expect(triangles.materials).toEqual([]);
      expect(model.notices).toEqual([{ code: 'lost-looks', params: { count: 1 } }]);
    }
  });

  it('are refused where a number is none', async () => {
    const bad = picture.replace('u="1"', 'u="one"');
    await expect(looked(bad + squareOf('', ''))).rejects.toMatchObject({ code: 'bad-3mf' });
  });
});
