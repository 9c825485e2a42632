/** Materials and pictures beside OBJ and PLY files, as the engine tells what it has read of these. */
import { describe, expect, it } from 'vitest';
import { FinishedResults } from '../../web/api/finished-results.js';
import type { EngineResult, JobResult } from '../../web/model/job.js';
import type { EngineLooks } from '../../web/model/looks.js';
import type { ModelFile } from '../../web/model/model-files.js';
import { isUsable, pictureKind } from '../../web/read/picture-kind.js';
import { Pictures } from '../../web/read/pictures.js';
import { withoutLooks } from './engine-result.js';
import { tetrahedronResult } from './fixtures.js';
import { beginnings, png } from './tiny-pictures.js';

const encode = (text: string): Uint8Array => new TextEncoder().encode(text);

const file = (name: string, content: string | Uint8Array = png): ModelFile => ({
  name,
  bytes: typeof content === 'string' ? encode(content) : content,
});

const mtl = 'newmtl wood\nKd 0.8 0.8 0.8\nmap_Kd wood.png\nnewmtl red\nKd 1 0 0\n';

interface Given {
  names?: string[];
  libraries?: string[];
  /** The model's own. */
  model?: ModelFile;
  surface?: Partial<EngineLooks['surface']>;
}

/** A tetrahedron as the engine gives it, with the looks of an OBJ file. */
function engineResult({
  names = ['wood', 'red'],
  libraries = ['a.mtl'],
  ...given
}: Given): EngineResult {
  const surface = {
    original: null,
    places: new Float32Array(24),
    colours: null,
    materials: Int32Array.of(0, 1, 0, 1),
    ...given.surface,
  };
  const looks: EngineLooks = { surface, materialNames: names, libraries };
  return { ...withoutLooks(tetrahedronResult()), file: given.model?.name ?? 'a.obj', looks };
}

/** What people get of it with these files beside it. */
function finished(given: Given, ...beside: ModelFile[]): JobResult {
  const model = given.model ?? file('a.obj', 'v 0 0 0');
  return new FinishedResults([model, ...beside], null).of(engineResult(given));
}

const notices = ({ notices: list }: JobResult): [string, unknown][] =>
  list.map(({ code, params }) => [code, Object.values(params).at(-1)]);

describe('the looks of an OBJ file', () => {
  it('are its materials in the order of their numbers, with the pictures that they name', () => {
    const result = finished({ names: ['red', 'wood'] }, file('a.mtl', mtl), file('wood.png'));
    expect(result.notices).toEqual([]);
    expect(result.looks?.pictures).toEqual([file('wood.png')]);
    expect(result.looks?.materials).toEqual([
      {
        name: 'red',
        colour: [255, 0, 0],
        picture: null,
        wrap: ['repeat', 'repeat'],
        scale: [1, 1],
        offset: [0, 0],
      },
      {
        name: 'wood',
        colour: [255, 255, 255],
        picture: 0,
        wrap: ['repeat', 'repeat'],
        scale: [1, 1],
        offset: [0, 0],
      },
    ]);
  });

  it('are found in other folders, cases and on other computers', () => {
    for (const [path, name] of [
      ['.\\Textures\\Wood.png', 'textures/wood.PNG'],
      ['C:\\Users\\me\\wood.png', 'wood.png'],
      ['/Volumes/disk/pictures/wood.png', 'pictures/wood.png'],
      ['..\\wood.png', 'wood.png'],
      ['textures/wood.png', 'mats/textures/wood.png'],
      ['my%20wood.png', 'my wood.png'],
      ['textures/wood.png', 'wood.png'],
    ] as const) {
      const library = file('mats/a.mtl', `newmtl wood\nmap_Kd ${path}`);
      const result = finished({ names: ['wood'], libraries: ['mats\\a.mtl'] }, library, file(name));
      expect([path, notices(result)]).toEqual([path, []]);
      expect(result.looks?.pictures.map((picture) => picture.name)).toEqual([name]);
    }
  });

  it('may lie in several libraries on a line, or in one with blanks in its name; the first word counts', () => {
    const [one, other] = [file('my wood.mtl', mtl), file('b.mtl', 'newmtl red\nKd 0 0 1')];
    const colours = (...libraries: string[]): unknown =>
      finished({ libraries }, one, other, file('wood.png')).looks?.materials.map(
        ({ colour }) => colour,
      );
    const expected = [
      [255, 255, 255],
      [255, 0, 0],
    ];
    expect(colours('my wood.mtl', 'b.mtl')).toEqual(expected);
    expect(colours('my wood.mtl b.mtl')).toEqual(expected);
    expect(colours('b.mtl my wood.mtl')).toEqual([
      [255, 255, 255],
      [0, 0, 255],
    ]);
  });

  it('say which files are missing, and keep the plain colour until then', () => {
    const result = finished({}, file('a.mtl', mtl));
    expect(notices(result)).toEqual([['missing-looks', ['wood.png']]]);
    expect(result.looks?.materials[0]).toMatchObject({ colour: [204, 204, 204], picture: null });
    const bare = finished({ libraries: ['a.mtl', 'b.mtl'] });
    expect(notices(bare)).toEqual([['missing-looks', ['a.mtl', 'b.mtl']]]);
    expect(bare.looks).toBeUndefined();
  });

  it('tell of pictures of other kinds, of libraries that are none, and of materials that are in none', () => {
    const given = { names: ['wood', 'gold'], libraries: ['a.mtl', 'b.mtl'] };
    const beside = [file('a.mtl', mtl), file('b.mtl', 'x'), file('wood.png', beginnings['DDS'])];
    expect(notices(finished(given, ...beside))).toEqual([
      ['unread-libraries', ['b.mtl']],
      ['unknown-materials', ['gold']],
      ['unread-pictures', ['DDS']],
    ]);
  });

  it('are the only picture beside a model that names none, which is told', () => {
    const given = { names: ['wood'], libraries: [], surface: { materials: new Int32Array(4) } };
    const result = finished(given, file('b.mtl', mtl), file('skin.png'));
    expect(result.looks).toMatchObject({
      materials: [{ picture: 0 }],
      pictures: [file('skin.png')],
    });
    expect(notices(result)).toEqual([['picture-guessed', 'skin.png']]);
    const bare = { ...given, names: [], surface: { materials: null } };
    expect(finished(bare, file('skin.png')).looks?.surface.materials).toEqual(new Int32Array(4));
    const twoNames = {
      ...given,
      names: ['a', 'b'],
      surface: { materials: Int32Array.of(0, 1, 1, -1) },
    };
    expect(finished(twoNames, file('skin.png')).looks?.surface.materials).toEqual(
      new Int32Array(4),
    );
    expect(finished(given, file('a.png'), file('b.png')).looks).toBeUndefined();
    expect(finished({ ...given, surface: { places: null } }, file('a.png')).looks).toBeUndefined();
  });

  it('are none where all is white', () => {
    const library = file('a.mtl', 'newmtl wood\nKd 1 1 1\nnewmtl red');
    expect(finished({}, library).looks).toBeUndefined();
    const colours = new Uint8Array(36);
    expect(finished({ surface: { colours } }, library).looks?.surface.colours).toBe(colours);
  });
});

describe('the looks of a PLY file', () => {
  const header = 'ply\nformat ascii 1.0\ncomment TextureFile skin one.png\nelement vertex 3\n';

  it('are the picture that its header names, for all faces or by their numbers', () => {
    const model = file('a.ply', `${header}end_header\ncomment TextureFile no.png\n`);
    const given = { model, names: [], libraries: [], surface: { materials: null } };
    const { looks, notices: told } = finished(given, file('skin one.png'));
    expect(told).toEqual([]);
    expect(looks?.materials).toMatchObject([{ picture: 0 }]);
    expect(looks?.surface.materials).toEqual(new Int32Array(4));
    const materials = Int32Array.of(-1, 0, 0, 0);
    const numbered = finished({ ...given, surface: { materials } }, file('skin one.png'));
    expect(numbered.looks?.surface.materials).toBe(materials);
  });

  it('say that the picture is missing', () => {
    const model = file('a.ply', `${header}end_header\n`);
    const given = { model, names: [], libraries: [], surface: { materials: null } };
    expect(notices(finished(given))).toEqual([['missing-looks', ['skin one.png']]]);
  });
});

describe('files beside a model', () => {
  it('are told as not needed only if nothing was made of them', () => {
    const library = file('a.mtl', `${mtl}newmtl unused\nmap_Kd d.png`);
    const beside = [library, file('wood.png'), file('b.png'), file('c.txt', ''), file('d.png')];
    const results = new FinishedResults([file('a.obj', ''), ...beside], null);
    const ignored = { code: 'files-ignored', params: { files: beside.map(({ name }) => name) } };
    const result = { ...engineResult({}), notices: [ignored] };
    const params = { files: ['b.png', 'c.txt'] };
    expect(results.of(result).notices).toEqual([{ code: 'files-ignored', params }]);
    const event = results.ofEvent({ type: 'cancelled', best: result, seconds: {} as never });
    expect(event).toMatchObject({ best: { notices: [{ params }], looks: { pictures: [{}] } } });
    expect(results.of(withoutLooks(result)).looks).toBeUndefined();
  });
});

describe('pictures', () => {
  it('are known by their contents, and some can be used', () => {
    for (const [kind, bytes] of Object.entries(beginnings)) expect(pictureKind(bytes)).toBe(kind);
    expect(Object.keys(beginnings).filter(isUsable)).toEqual([
      'PNG',
      'JPEG',
      'GIF',
      'WebP',
      'BMP',
      'TGA',
    ]);
    expect(pictureKind(new Uint8Array())).toBe('');
  });

  it('are taken once each, and no more than can be used', () => {
    const pictures = new Pictures();
    const large = new Uint8Array(40 * 2 ** 20);
    large.set(png);
    expect(pictures.add('a', 'a.png', () => file('a.png', large))).toBe(0);
    expect(pictures.add('a', 'a.png', () => expect.fail('looked for twice'))).toBe(0);
    expect(pictures.add('b', 'b.png', () => file('b.png', large))).toBeNull();
    expect(pictures.add('c', 'c.png', () => file('c.png'))).toBe(1);
    expect(pictures.notices).toEqual([
      { code: 'large-pictures', params: expect.objectContaining({ files: ['b.png'] }) as unknown },
    ]);
    const wide = png.slice();
    new DataView(wide.buffer).setUint32(16, 20_000);
    expect(pictures.add('d', 'd.png', () => file('d.png', wide))).toBeNull();
    expect(pictures.add('e', 'e.png', () => file('e.png', png.subarray(0, 20)))).toBeNull();
    expect(pictures.notices.map(({ code }) => code)).toEqual(['unread-pictures', 'large-pictures']);
    const many = new Pictures();
    const numbers = Array.from({ length: 300 }, (_, i) => many.add(`${i}`, '', () => file('x')));
    expect(numbers.filter((number) => number !== null)).toHaveLength(256);
  });
});
