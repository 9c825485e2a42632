import { describe, expect, it } from 'vitest';
import type { ModelFile } from '../../web/model/model-files.js';
import { codesOf, read, refusal, sizeOf, trianglesOf, volumeOf } from './read-model.js';
import { box } from './solids.js';
import { meshObject, modelPart, threeMf } from './zips.js';

const unitBox = meshObject(1, box(1, 1, 1));

async function measured(file: ModelFile): Promise<{ volume: number; size: number[] }> {
  const triangles = trianglesOf((await read(file)).file);
  return { volume: Number(volumeOf(triangles).toFixed(3)), size: sizeOf(triangles) };
}

describe('what a 3MF file builds', () => {
  it('is placed by items, and in millimetres, with z up', async () => {
    const items = '<item objectid="1"/><item objectid="1" transform="0 2 0 -1 0 0 0 0 1 10 0 0"/>';
    const file = threeMf(modelPart(unitBox, items, 'unit="inch"'));
    expect(await measured(file)).toEqual({ volume: 49161.192, size: [254, 50.8, 25.4] });
    expect((await read(file)).usual).toEqual({ up: 'z', unit: 'mm' });
  });

  it('is made of components within components; mirrored ones keep their outsides outside', async () => {
    const resources =
      unitBox +
      '<object id="2"><components><component objectid="1"/>' +
      '<component objectid="1" transform="-1 0 0 0 1 0 0 0 1 0 0 0"/></components></object>' +
      '<object id="3"><components><component objectid="2" transform="1 0 0 0 1 0 0 0 2 0 0 0"/></components></object>';
    const file = threeMf(
      modelPart(resources, '<item objectid="3" transform="2 0 0 0 2 0 0 0 2 0 0 0"/>'),
    );
    expect(await measured(file)).toEqual({ volume: 32, size: [4, 2, 4] });
  });

  it('may lie in parts of its own, whose numbers are their own, and begin anywhere', async () => {
    const resources =
      '<object id="1"><components><component p:path="/3D/Objects/a.model" objectid="1"/>' +
      '<component p:path="/3D/Objects/b.model" objectid="1" transform="1 0 0 0 1 0 0 0 1 5 0 0"/></components></object>';
    const file = threeMf(
      modelPart(resources, '<item objectid="1"/>', 'requiredextensions="p"'),
      {
        '3D/Objects/a.model': modelPart(unitBox),
        '3D/Objects/b.model': modelPart(meshObject(1, box(2, 2, 2))),
      },
      '/odd/My%20Model.model',
    );
    const model = await read(file);
    expect(volumeOf(trianglesOf(model.file))).toBeCloseTo(9);
    expect(model.notices).toEqual([]);
  });

  it('is found in a package of very many files', async () => {
    const pictures = Array.from({ length: 1500 }, (_, i) => [
      `Metadata/${i}-${'x'.repeat(50)}.png`,
      'x',
    ]);
    const model = modelPart(unitBox, '<item objectid="1"/>');
    const file = threeMf(model, Object.fromEntries(pictures) as Record<string, string>);
    expect((await measured(file)).volume).toBe(1);
  });

  it('is all that no other object is made of, where nothing says what is built', async () => {
    const resources = `${unitBox}<object id="2"><components><component objectid="1"/></components></object>`;
    expect((await measured(threeMf(modelPart(resources)))).volume).toBe(1);
  });

  it('leaves out what is not printed, and tells how much', async () => {
    const resources =
      unitBox +
      meshObject(2, box(3, 3, 3), 'support') +
      meshObject(3, box(2, 2, 2)) +
      '<object id="4"><components><component objectid="1"/><component objectid="3"/></components></object>';
    const items =
      '<item objectid="4"/><item objectid="2"/><item objectid="1" printable="0"/><item objectid="3"/>';
    const settings =
      '<config><object id="4"><part id="1" subtype="normal_part"/>' +
      '<part id="3" subtype="negative_part"/></object></config>';
    const slic3r =
      '<config><object id="3"><volume firstid="0" lastid="1"><metadata key="volume_type" value="SupportBlocker"/>' +
      '</volume></object></config>';
    const model = await read(
      threeMf(modelPart(resources, items), {
        'Metadata/model_settings.config': settings,
        'Metadata/Slic3r_PE_model.config': slic3r,
      }),
    );
    const params = { supports: 1, modifiers: 1, negatives: 1, unprinted: 1 };
    expect(model.notices).toEqual([{ code: 'not-for-printing', params }]);
    expect(trianglesOf(model.file).corners).toHaveLength(3 * (12 + 10));
  });
});

describe('what a 3MF file carries beside its shape', () => {
  it('is told', async () => {
    const colours =
      '<m:colorgroup xmlns:m="http://schemas.microsoft.com/3dmanufacturing/material/2015/02" id="9"/>';
    const attributes = 'xmlns:x="http://example.org/x" requiredextensions="p x"';
    const file = threeMf(modelPart(colours + unitBox, '<item objectid="1"/>', attributes));
    const model = await read(file);
    expect(codesOf(model)).toEqual(['unknown-extensions']);
    expect(model.notices[0]!.params).toEqual({ names: ['http://example.org/x'] });
  });
});

describe('the precision of 3MF', () => {
  it('is that of its decimals, wherever the object stands', async () => {
    const { positions, corners } = box(1.25, 2.37, 3.111);
    const item = '<item objectid="1" transform="0.6 0.8 0 -0.8 0.6 0 0 0 1 7 0 0"/>';
    const { file } = await read(threeMf(modelPart(meshObject(1, { positions, corners }), item)));
    const [, data = ''] = new TextDecoder().decode(file.bytes).split('end_header');
    const words = data.split(/\s+/);
    const decimals = words
      .filter((word) => word.includes('.'))
      .map((word) => word.split('.')[1]!.length);
    expect(new Set(decimals)).toEqual(new Set([3]));
  });
});

describe('3MF files that cannot be read', () => {
  const refused = (model: string, more = {}): Promise<string> => refusal([threeMf(model, more)]);

  it('say why', async () => {
    const item = '<item objectid="1"/>';
    expect(await refused('<model')).toMatch(/'\/3D\/3dmodel.model' is no XML at line 1/);
    expect(await refused(modelPart(unitBox.replace('x="1"', 'x="nan"'), item))).toMatch(
      /stands 'nan' where/,
    );
    expect(await refused(modelPart(unitBox.replace('v1="0"', 'v1="99"'), item))).toMatch(
      /face refers to vertex 99/,
    );
    expect(await refused(modelPart(unitBox, '<item objectid="7"/>'))).toMatch(/refers to object 7/);
    const away =
      '<object id="1"><components><component p:path="/a.model" objectid="1"/></components></object>';
    expect(await refused(modelPart(away, item))).toMatch(
      /refers to '\/a.model', which is not in it/,
    );
    expect(await refused(modelPart('', ''))).toMatch(/nothing that is to be printed/);
    expect(await refused(modelPart('', ''), { 'Metadata/plate_1.gcode': 'G1' })).toMatch(
      /\(G-code\)/,
    );
  });

  it('are those whose objects hold themselves, or each other many times over', async () => {
    const self = '<object id="1"><components><component objectid="1"/></components></object>';
    expect(await refused(modelPart(self, '<item objectid="1"/>'))).toMatch(/holds itself/);
    const levels = Array.from({ length: 40 }, (_, i) => {
      const half = `<component objectid="${i}"/>`;
      return `<object id="${i + 1}"><components>${half}${half}</components></object>`;
    });
    const empty = '<object id="0"><mesh/></object>';
    expect(await refused(modelPart(empty + levels.join(''), '<item objectid="40"/>'))).toMatch(
      /far too many others/,
    );
  });
});
