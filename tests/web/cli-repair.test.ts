/** What the command line mends of a model on request, and what it tells of it. */
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import type { Report } from '../../web/export/report.js';
import { foldwright, inFolder, isBuilt } from './command.js';
import { cube } from './fixtures.js';
import { objText } from './model-text.js';

/** A cube without its last side, which is two triangles. */
const openBox = objText({ ...cube, faces: cube.faces.slice(0, -2) });

async function run(model: string, options: string[]): Promise<{ notes: string; report: Report }> {
  return inFolder(async (folder) => {
    const [file, path] = [join(folder, 'model.obj'), join(folder, 'report.json')];
    writeFileSync(file, model);
    const { stderr, status } = await foldwright([file, '--report', path, ...options]);
    expect(status).toBe(0);
    return { notes: stderr, report: JSON.parse(readFileSync(path, 'utf8')) as Report };
  });
}

function repairsOf({ model }: Report): Record<string, number> {
  return Object.fromEntries(model.repairs.map(({ code, count }) => [code, count]));
}

/** A cube with another one half as large in its middle, as a hollow if it is inside out. */
function nested(isHollow: boolean): string {
  const inner = cube.vertices.map((vertex) => vertex.map((x) => 10 + x / 2));
  const faces = cube.faces.map((face) => face.map((vertex) => vertex + cube.vertices.length));
  if (isHollow) for (const face of faces) face.reverse();
  return objText({
    vertices: [...cube.vertices, ...inner],
    faces: [...cube.faces, ...faces],
  });
}

describe.skipIf(!isBuilt)('bodies inside others', () => {
  it.each([false, true])('are kept, with the option that drops them (hollow: %s)', async (is) => {
    const { notes, report } = await run(nested(is), []);
    expect(notes).toContain(
      'note: 1 body lies inside another one, where nobody will see it (--inside drop leaves it out)',
    );
    expect(repairsOf(report)).toEqual({ 'inner-bodies': 1 });
    expect(report.model).toMatchObject({ faces: 24, components: 2 });
  });

  it('are left out on request', async () => {
    const { notes, report } = await run(nested(true), ['--inside', 'drop', '--parts', '1']);
    expect(notes).toContain(
      'note: 1 body (12 faces) was left out, since nobody sees what lies inside another one',
    );
    expect(repairsOf(report)).toEqual({ 'dropped-inner-bodies': 1 });
    expect(report.model).toMatchObject({ faces: 12, components: 1 });
    expect(report.segmentation).toEqual(Array.from({ length: 24 }, (_, i) => (i < 12 ? 1 : -1)));
  });
});

/** A cube, and a bar that stands out of one of its sides: their places have no end as single floats. */
function cubeAndBar(hole = 0): string {
  const bar = cube.vertices.map(([x, y, z]) => [25.1 + x! / 2, 13.3 + y! / 4, 13.3 + z! / 4]);
  const faces = cube.faces.map((face) => face.map((vertex) => vertex + cube.vertices.length));
  return objText({
    vertices: [...cube.vertices, ...bar],
    faces: [...cube.faces, ...faces.slice(0, faces.length - hole)],
  });
}

describe.skipIf(!isBuilt)('bodies that run through each other', () => {
  it('are kept, with the option that unites them', async () => {
    const { notes, report } = await run(cubeAndBar(), []);
    expect(notes).toContain('would collide when assembled (--crossing unite makes one of them)');
    expect(repairsOf(report)).toMatchObject({ 'crossing-bodies': 1 });
    expect(report.model.components).toBe(2);
  });

  it('are united on request, and each face of the file has its part', async () => {
    const { notes, report } = await run(cubeAndBar(), ['--crossing', 'unite', '--parts', '1']);
    expect(notes).toContain('note: 2 bodies that ran through each other were united; nothing is');
    expect(notes).not.toContain('would collide');
    expect(report.model.components).toBe(1);
    // The side of the cube with the bar in it is a ring, which the bar's own net does not lie in.
    expect(report.pieces.length).toBe(2);
    expect(report.segmentation.length).toBe(24);
    // Of the bar, the side within the cube is gone.
    expect(report.segmentation.filter((part) => part === -1).length).toBe(2);
    expect(new Set(report.segmentation)).toEqual(new Set([1, -1]));
    expect(report.options['crossing']).toBe('unite');
  });

  it('stay where one of them is open, until it is closed', async () => {
    const open = cubeAndBar(2);
    const { notes } = await run(open, ['--crossing', 'unite']);
    expect(notes).toContain('1 body that runs through others could not be united with them');
    const { report } = await run(open, ['--crossing', 'unite', '--fill-holes', 'all']);
    expect(report.model.components).toBe(1);
  });
});

/** A cube with one triangle the other way round. */
const turned = objText({
  ...cube,
  faces: cube.faces.map((f, i) => (i === 0 ? [...f].reverse() : f)),
});

describe.skipIf(!isBuilt)('steps of the repair', () => {
  it('are done unless they are switched off', async () => {
    const { report } = await run(turned, []);
    expect(repairsOf(report)).toEqual({ 'flipped-faces': 1 });
    expect(report.options['repair']).toBe('on');
    expect(report.model.components).toBe(1);
  });

  it('are told where they are off, and what comes of it is unfolded', async () => {
    const { notes, report } = await run(turned, [
      '--repair',
      'winding=off',
      '--repair',
      'weld=off',
    ]);
    expect(notes).toContain(
      'note: turning faces over was switched off: 1 face has its printed side inside, and comes apart',
    );
    expect(notes).toContain('6 edges lie on the border of 2 open surfaces without a volume');
    expect(repairsOf(report)).toMatchObject({ 'step-off': 1, 'open-border': 6 });
    expect(report.options['repair']).toBe('weld=off,winding=off');
    expect(report.model).toMatchObject({ faces: 12, components: 2 });
    expect(report.segmentation.every((part) => part >= 1)).toBe(true);
  });

  it('that unfolding needs are refused by name', () =>
    inFolder(async (folder) => {
      const file = join(folder, 'model.obj');
      writeFileSync(file, turned);
      const { stderr, status } = await foldwright([file, '--repair', 'weld=off,non-manifold=off']);
      expect(status).toBe(2);
      expect(stderr).toContain(
        "'non-manifold', which cannot be switched off: a fold joins two faces and no more",
      );
    }));
});

describe.skipIf(!isBuilt)('holes', () => {
  it('are left open, with the option that fills them', async () => {
    const { notes, report } = await run(openBox, []);
    expect(notes).toContain(
      "note: 1 hole is left open, 141.5 % of the model's longest side across (--fill-holes all fills it)",
    );
    expect(report.model.faces).toBe(10);
    expect(report.options['fill-holes']).toBe('off');
  });

  it('are filled on request, with an entry for each face of the file as ever', async () => {
    const { notes, report } = await run(openBox, ['--fill-holes', 'all', '--parts', '1']);
    expect(notes).toContain('note: 1 hole was filled with new faces, in the colours beside it');
    expect(repairsOf(report)).toEqual({ 'filled-holes': 1 });
    expect(report.model.faces).toBe(12);
    expect(report.segmentation).toEqual(Array.from({ length: 10 }, () => 1));
  });

  it('that are wider than asked for are left open', async () => {
    const { report } = await run(openBox, ['--fill-holes', '20']);
    expect(repairsOf(report)).toMatchObject({ 'open-holes': 1 });
    expect(report.model.faces).toBe(10);
  });
});
