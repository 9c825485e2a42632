/** A finished model as its files say that it looks. */
import { expect, test } from 'vitest';
import { objText, wavyRing } from '../web/model-text.js';
import { useStudio } from './studio-fixture.js';
import type { StudioPage } from './studio-page.js';

const withStudio = useStudio();

/** Two pixels one above the other: red and blue. */
const picture = Buffer.from(
  'iVBORw0KGgoAAAANSUhEUgAAAAEAAAACCAIAAAAW4yFwAAAADUlEQVR4nGP4zwAC/wEIAAH/2ZC7NQAAAABJRU5ErkJggg==',
  'base64',
);

/** A ring whose faces all lie in the upper pixel. */
const ring = objText(wavyRing(6));
const painted = `mtllib ring.mtl\nvt 0.5 0.75\nusemtl skin\n${ring.replace(/^f (\d+) (\d+) (\d+)/gm, 'f $1/1 $2/1 $3/1')}`;
const files = [
  { name: 'ring.obj', content: painted },
  { name: 'ring.mtl', content: 'newmtl skin\nmap_Kd Skin.png\n' },
  { name: 'skin.png', content: picture },
];

/** Shares of the model's picture that are clearly red, and clearly blue. */
async function shares(studio: StudioPage): Promise<[number, number]> {
  const shot = await studio.page.locator('#model-picture').screenshot();
  return studio.page.evaluate(
    async (source) => {
      const image = new Image();
      image.src = source;
      await image.decode();
      const canvas = new OffscreenCanvas(image.width, image.height);
      const context = canvas.getContext('2d')!;
      context.drawImage(image, 0, 0);
      const { data } = context.getImageData(0, 0, image.width, image.height);
      let [red, blue] = [0, 0];
      for (let at = 0; at < data.length; at += 4) {
        const [r, g, b] = [data[at]!, data[at + 1]!, data[at + 2]!];
        if (r > 100 && g < r / 4 && b < r / 4) ++red;
        if (b > 100 && g < b / 4 && r < b / 4) ++blue;
      }
      return [(4 * red) / data.length, (4 * blue) / data.length] as [number, number];
    },
    `data:image/png;base64,${shot.toString('base64')}`,
  );
}

test('a switch shows the model in its pictures, the right way up, and stays for the next one', () =>
  withStudio(async (studio) => {
    await studio.chooseTogether(files);
    await studio.resultOf('ring');
    const box = studio.page.locator('#looks');
    await box.waitFor();
    await studio.drawn('#model-picture');
    expect((await shares(studio))[0]).toBe(0);
    await box.check();
    await expect.poll(async () => (await shares(studio))[0]).toBeGreaterThan(0.02);
    expect((await shares(studio))[1]).toBe(0);
    await studio.picture('looks');
    // Who paints parts sees these.
    const brush = studio.page.locator('#brush');
    await brush.check();
    await expect.poll(async () => (await shares(studio))[0]).toBe(0);
    await brush.uncheck();
    await expect.poll(async () => (await shares(studio))[0]).toBeGreaterThan(0.02);
    await studio.choose('plain.obj', ring);
    await studio.resultOf('plain');
    expect(await box.isVisible()).toBe(false);
    await expect.poll(async () => (await shares(studio))[0]).toBe(0);
    await studio.chooseTogether(files);
    await studio.resultOf('ring');
    await expect.poll(async () => (await shares(studio))[0]).toBeGreaterThan(0.02);
    await box.uncheck();
    await expect.poll(async () => (await shares(studio))[0]).toBe(0);
    expect(studio.complaints).toEqual([]);
  }));

test('a missing picture is named', () =>
  withStudio(async (studio) => {
    await studio.chooseTogether(files.slice(0, 2));
    await studio.resultOf('ring');
    expect(await studio.page.locator('#result-side').innerText()).toContain(
      'picture Skin.png is missing',
    );
    expect(await studio.page.locator('#looks').isVisible()).toBe(false);
  }));

test('what is missing can be added after the model, one file after the other', () =>
  withStudio(async (studio) => {
    const [model, materials, skin] = files;
    const result = studio.page.locator('#result-side');
    await studio.chooseTogether([model!]);
    await studio.resultOf('ring');
    expect(await result.innerText()).toContain('choose it as well, or choose the whole folder');
    await studio.drop([materials!]);
    await expect.poll(() => result.innerText()).toContain('picture Skin.png is missing');
    await studio.resultOf('ring');
    await studio.chooseTogether([skin!]);
    await studio.page.locator('#looks').waitFor();
    const words = 'Chosen: ring.obj, ring.mtl and skin.png';
    await expect.poll(() => studio.page.locator('#chosen').innerText()).toBe(words);
    expect(await studio.page.locator('#message').isVisible()).toBe(false);
    expect(studio.complaints).toEqual([]);
  }));
