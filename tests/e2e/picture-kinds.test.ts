/** Pictures of kinds that browsers read differently, or not at all, are the same on screen, in print and in the command's files. */
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from 'vitest';
import { foldwright, inFolder } from '../web/command.js';
import { objText, wavyRing } from '../web/model-text.js';
import { tgaOf } from '../web/tga-file.js';
import { useStudio } from './studio-fixture.js';

const withStudio = useStudio();

/** Two pixels one above the other, red and blue, of each kind. */
const pictures: Readonly<Record<string, Uint8Array>> = {
  tga: tgaOf(
    { kind: 'colours', depth: 24, isFromAbove: true },
    [1, 2],
    [
      [0, 0, 255],
      [255, 0, 0],
    ],
  ),
  bmp: Uint8Array.from([
    ...[0x42, 0x4d, 62, 0, 0, 0, 0, 0, 0, 0, 54, 0, 0, 0, 40, 0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0],
    ...[1, 0, 24, 0, 0, 0, 0, 0, 8, 0, 0, 0, ...new Uint8Array(16)],
    ...[255, 0, 0, 0, 0, 0, 255, 0],
  ]),
  webp: Buffer.from('UklGRh4AAABXRUJQVlA4TBIAAAAvAEAAAA8Q87//8x8OJiCi/xE=', 'base64'),
};

/** A ring whose faces all lie in the upper pixel. */
const ring = objText(wavyRing(6)).replace(/^f (\d+) (\d+) (\d+)/gm, 'f $1/1 $2/1 $3/1');

function filesWith(kind: string): { name: string; content: string | Uint8Array }[] {
  return [
    { name: `ring-${kind}.obj`, content: `mtllib ring.mtl\nvt 0.5 0.75\nusemtl skin\n${ring}` },
    { name: 'ring.mtl', content: `newmtl skin\nmap_Kd skin.${kind}\n` },
    { name: `skin.${kind}`, content: pictures[kind]! },
  ];
}

test('pictures are shown and printed as the command prints them', () =>
  withStudio(async (studio) => {
    for (const kind of Object.keys(pictures)) {
      const files = filesWith(kind);
      await studio.chooseTogether(files);
      await expect
        .poll(() => studio.page.locator('#chosen').innerText())
        .toBe(`Chosen: ring-${kind}.obj`);
      await studio.resultOf(`ring-${kind}`);
      await studio.page.locator('#looks').check();
      await studio.drawn('#model-picture');
      await studio.picture(`kind-${kind}`);
      const { bytes } = await studio.download('SVG');
      await inFolder(async (folder) => {
        for (const { name, content } of files) writeFileSync(join(folder, name), content);
        const [model, drawing] = [join(folder, files[0]!.name), join(folder, 'ring.svg')];
        const { status } = await foldwright([model, '-o', drawing]);
        expect(status).toBe(0);
        expect([kind, bytes.equals(readFileSync(drawing))]).toEqual([kind, true]);
      });
      expect(bytes.toString()).toContain('data:image/png');
    }
    expect(studio.complaints).toEqual([]);
  }));
