import UPNG from '@pdf-lib/upng';
/** What goes wrong is told in a sentence, costs nothing, and the page goes on. */
import { expect, test } from 'vitest';
import { objText, wavyRing } from '../web/model-text.js';
import { useStudio } from './studio-fixture.js';
import type { StudioPage } from './studio-page.js';

const withStudio = useStudio();

async function nextRunWorks(studio: StudioPage): Promise<void> {
  await studio.chooseSample('House');
  await studio.resultOf('house');
  expect(await studio.page.locator('#message').isVisible()).toBe(false);
}

test('a broken model shows the reason and leaves the last result', () =>
  withStudio(async (studio) => {
    await studio.chooseSample('Cube');
    await studio.resultOf('cube');
    await studio.choose('broken.obj', 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n');
    const words = await studio.message();
    expect(words).toContain('“broken.obj” could not be unfolded');
    expect(words).toContain('9');
    expect(await studio.page.locator('#result-title').innerText()).toBe('cube');
    expect((await studio.download('FOLD')).name).toBe('cube.fold');
    await studio.picture('message');
    await nextRunWorks(studio);
    expect(studio.complaints).toEqual([]);
  }));

test('a run that fails after a result leaves all of that result', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    const { vertices, faces } = wavyRing(6);
    await studio.choose('ring.obj', objText({ vertices, faces }));
    const hash = await studio.resultOf('ring');
    await studio.drawn('#model-picture');
    await page.locator('.part').first().click();
    await page.waitForTimeout(500);
    const picture = await page.locator('#model-picture').screenshot();

    // As many faces, but another shape: the model of the one must not stay with the nets of the other.
    await page.selectOption('#sizing', 'scale');
    await page.fill('#size', '100000');
    const tall = vertices.map(([x, y, z]) => [x!, 5 * y!, z!]);
    await studio.choose('tall.obj', objText({ vertices: tall, faces }));
    const words = await studio.message();
    expect(words).toContain('“tall.obj” could not be unfolded');
    expect(words).toContain('still the result of “ring.obj”');
    expect(words).toContain('Change the settings');
    expect(await page.locator('#chosen').innerText()).toBe('Chosen: tall.obj');

    expect(await page.locator('#workshop').isVisible()).toBe(false);
    expect(await page.locator('#result').getAttribute('data-hash')).toBe(hash);
    expect(await page.locator('#result-title').innerText()).toBe('ring');
    expect(await page.locator('#result #model-name').innerText()).toBe('ring.obj');
    expect(await page.locator('#result-pictures #pictures').count()).toBe(1);
    await page.locator('#message-close').click();
    await expect
      .poll(
        async () =>
          rowsOf(picture).equals(rowsOf(await page.locator('#model-picture').screenshot())),
        {
          timeout: 20_000,
        },
      )
      .toBe(true);
    expect((await studio.download('FOLD')).name).toBe('ring.fold');
    expect(await page.locator('.pending:visible').first().innerText()).toContain('Size and Factor');
    expect(studio.complaints).toEqual([]);
  }));

test('an empty file, two models and a strange file are refused', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    const isRefused = async (): Promise<void> => {
      expect(await page.locator('#chosen').innerText()).toBe(
        'GLB, OBJ, STL, 3MF, PLY, OFF, PDO, FOLD or ZIP',
      );
      expect(await page.locator('#unfold').isDisabled()).toBe(true);
    };
    await studio.choose('empty.stl', '');
    expect(await studio.message()).toContain('“empty.stl” is empty');
    await isRefused();
    const [one, two] = ['one.obj', 'two.obj'].map((name) => ({ name, content: 'v 0 0 0\n' }));
    await studio.drop([one!, two!]);
    await page.getByText("two models among the files: 'one.obj' and 'two.obj'").waitFor();
    await isRefused();
    await studio.choose('letter.docx', 'Dear Sir or Madam');
    await page.getByText('“letter.docx” could not be unfolded').waitFor();
    await isRefused();
    await nextRunWorks(studio);

    // The model before stays the chosen one.
    await studio.choose('letter.docx', 'Dear Sir or Madam');
    await page.getByText('“letter.docx” could not be unfolded').waitFor();
    expect(await page.locator('#chosen').innerText()).toBe('Chosen: house.obj');
    expect(await page.locator('.sample[aria-pressed="true"]').innerText()).toBe('House');
    await page.locator('#unfold').click();
    await page.locator('#message').waitFor({ state: 'hidden' });
    await studio.resultOf('house');
    expect(studio.complaints).toEqual([]);
  }));

test('cancel ends a run at once, and the next run works', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await page.fill('#parts', '1');
    await page.selectOption('#solver', 'genetic');
    await studio.choose('ring.obj', objText(wavyRing(30)));
    await page.locator('#cancel').click();
    await page.locator('#progress').waitFor({ state: 'hidden', timeout: 3000 });
    expect(await page.locator('#announcement').textContent()).toBe('Cancelled.');
    // Either nothing was to be seen yet, or what was there stays.
    expect(await page.locator('#welcome, #workshop').filter({ visible: true }).count()).toBe(1);
    await page.fill('#parts', '');
    await page.selectOption('#solver', 'tree');
    await nextRunWorks(studio);
    expect(studio.complaints).toEqual([]);
  }));

test('a new choice ends the run before it', () =>
  withStudio(async (studio) => {
    await studio.choose('ring.obj', objText(wavyRing(30)));
    await studio.page.locator('#cancel').waitFor();
    await nextRunWorks(studio);
    expect(studio.complaints).toEqual([]);
  }));

test('a worker that dies is replaced', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    // The routes of a context also see what workers ask for.
    await page.context().route('**/*.wasm', (route) => route.abort());
    // The first worker is started ahead of the first run.
    await page.reload();
    await studio.chooseSample('Cube');
    expect(await studio.message()).toContain('stopped unexpectedly');
    await page.context().unroute('**/*.wasm');
    await nextRunWorks(studio);
  }));

test('sheets that cannot be drawn are told of', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await page.context().route('**/writer-worker*', (route) => route.abort());
    await studio.chooseSample('Cube');
    expect(await studio.message()).toContain('could not be drawn');
    expect(await page.locator('#progress').isVisible()).toBe(false);
    await page.context().unroute('**/writer-worker*');
    await nextRunWorks(studio);
  }));

test('a browser without SIMD is told which one to use', () =>
  withStudio(
    async (studio) => {
      expect(await studio.message()).toContain('Safari since 16.4');
      expect(await studio.page.locator('#file').isDisabled()).toBe(true);
    },
    { script: 'WebAssembly.validate = () => false;' },
  ));

test('a number of parts that makes no sense is pointed out', () =>
  withStudio(async (studio) => {
    await studio.page.fill('#parts', '0');
    await studio.chooseSample('Cube');
    // It is looked at when the sample has come.
    const isInvalid = (): Promise<string | null> =>
      studio.page.locator('#parts').getAttribute('aria-invalid');
    await expect.poll(isInvalid).toBe('true');
    expect(await studio.page.locator('#progress').isVisible()).toBe(false);
    await studio.page.fill('#parts', '');
    await nextRunWorks(studio);
  }));

test('what is meant for a field stays in it', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    const dropsText = (selector: string): Promise<boolean> =>
      page.locator(selector).evaluate((target) => {
        const dataTransfer = new DataTransfer();
        dataTransfer.setData('text/plain', '4');
        const event = { dataTransfer, bubbles: true, cancelable: true, composed: true };
        // Whoever prevents the default takes the text away from the field.
        const kept = ['dragover', 'drop'].map((type) =>
          target.dispatchEvent(new DragEvent(type, event)),
        );
        return kept.every(Boolean);
      });
    expect(await dropsText('#parts')).toBe(true);
    expect(await page.locator('#message').isVisible()).toBe(false);
    expect(await dropsText('#welcome')).toBe(false);
    expect(await studio.message()).toContain('That was no file');

    await page.fill('#parts', '1');
    await page.selectOption('#solver', 'genetic');
    await studio.choose('ring.obj', objText(wavyRing(30)));
    await page.locator('#cancel').waitFor();
    await page.locator('#parts').press('Escape');
    await page.waitForTimeout(300);
    expect(await page.locator('#cancel').isVisible()).toBe(true);
    await page.locator('#cancel').press('Escape');
    await page.locator('#progress').waitFor({ state: 'hidden', timeout: 3000 });
    expect(studio.complaints).toEqual([]);
  }));

/** The pixels of a picture but for its last row, where the page below may show by a part of one. */
function rowsOf(png: Buffer): Buffer {
  const decoded = UPNG.decode(Uint8Array.from(png).buffer);
  const [pixels] = UPNG.toRGBA8(decoded);
  return Buffer.from(pixels!).subarray(0, 4 * decoded.width * (decoded.height - 1));
}
