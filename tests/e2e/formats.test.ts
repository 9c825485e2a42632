/** Models of formats that are read in the workers before the engine sees them. */
import { writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { KHRDracoMeshCompression } from '@gltf-transform/extensions';
import { expect, test } from 'vitest';
import { foldwright, inFolder, readReport } from '../web/command.js';
import { encoded, Scene } from '../web/gltf-files.js';
import { wavyRing } from '../web/model-text.js';
import { box } from '../web/solids.js';
import { meshObject, modelPart, threeMf, zip } from '../web/zips.js';
import { useStudio } from './studio-fixture.js';

const withStudio = useStudio();

/** A GLB file of a ring, compressed with Draco, whose decoder is loaded for it. */
async function dracoRing(): Promise<Uint8Array> {
  const { vertices, faces } = wavyRing(6);
  const scene = new Scene();
  scene.add({ positions: vertices.flat(), corners: faces.flat() });
  scene.document.createAnimation();
  scene.document.createExtension(KHRDracoMeshCompression).setRequired(true);
  return scene.glb();
}

/** The hash of what the command line makes of a file. */
function hashByCommand(name: string, bytes: Uint8Array): Promise<string> {
  return inFolder(async (folder) => {
    const [model, report] = [join(folder, name), join(folder, 'report.json')];
    await writeFile(model, bytes);
    const { stderr } = await foldwright([model, '--report', report, '--quiet']);
    expect(stderr).toBe('');
    return readReport(report).result_hash;
  });
}

test('a dropped GLB gives sheets, the same as by the command line', async () => {
  const bytes = await dracoRing();
  await withStudio(async (studio) => {
    const before = studio.requests.filter((address) => /read-gltf|draco/.test(address));
    await studio.drop([{ name: 'ring.glb', content: bytes }]);
    expect(await studio.resultOf('ring')).toBe(await hashByCommand('ring.glb', bytes));
    expect(await studio.page.locator('#chosen').innerText()).toBe('Chosen: ring.glb');
    expect(await studio.page.locator('#sheets svg').count()).toBeGreaterThan(0);
    expect(await studio.page.locator('#result-side').innerText()).toMatch(/not used: 1 animation/i);
    expect((await studio.download('FOLD')).name).toBe('ring.fold');
    // Nothing of it is loaded before it is needed.
    expect(before).toEqual([]);
    expect(studio.complaints).toEqual([]);
  });
});

test('a dropped archive and a dropped 3MF give sheets', async () => {
  const scene = new Scene();
  scene.add(box(1, 2, 3));
  const { json, bin } = await scene.separate();
  const archive = zip('box.zip', { 'deep/box.gltf': encoded(json), 'deep/data.bin': bin });
  const printed = threeMf(modelPart(meshObject(1, box(10, 20, 30)), '<item objectid="1"/>'));
  await withStudio(async (studio) => {
    await studio.drop([{ name: 'box.zip', content: archive.bytes }]);
    expect(await studio.resultOf('box')).toBe(await hashByCommand('box.zip', archive.bytes));
    expect(await studio.page.locator('#chosen').innerText()).toBe('Chosen: deep/box.gltf');
    await studio.drop([{ name: 'print.3mf', content: printed.bytes }]);
    expect(await studio.resultOf('print')).toBe(await hashByCommand('print.3mf', printed.bytes));
    expect(studio.complaints).toEqual([]);
  });
});

test('a glTF file says what is missing, and is read together with that', async () => {
  const scene = new Scene();
  scene.add(box(1, 2, 3));
  const { json, bin } = await scene.separate();
  const model = { name: 'box.gltf', content: encoded(json) };
  await withStudio(async (studio) => {
    await studio.drop([model]);
    const message = studio.page.locator('#message');
    await message.getByText('needs data.bin, which is missing').waitFor();
    await studio.drop([model, { name: 'data.bin', content: bin }]);
    expect(await studio.resultOf('box')).not.toBe('');
    expect(studio.complaints).toEqual([]);
  });
});
