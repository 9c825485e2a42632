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
