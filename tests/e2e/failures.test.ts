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

test('an empty file, several files and a strange file are refused', () =>
  withStudio(async (studio) => {
    await studio.choose('empty.stl', '');
    expect(await studio.message()).toContain('“empty.stl” is empty');
    const [one, two] = ['one.obj', 'two.obj'].map((name) => ({ name, content: 'v 0 0 0\n' }));
    await studio.drop([one!, two!]);
    await studio.page.getByText('Those were 2 files').waitFor();
    await studio.choose('letter.docx', 'Dear Sir or Madam');
    await studio.page.getByText('“letter.docx” could not be unfolded').waitFor();
    await nextRunWorks(studio);
    expect(studio.complaints).toEqual([]);
  }));

test('cancel ends a run at once, and the next run works', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await page.fill('#parts', '1');
    await page.selectOption('#solver', 'genetic');
    await studio.choose('ring.obj', objText(wavyRing(60)));
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
    await studio.choose('ring.obj', objText(wavyRing(60)));
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
    expect(await studio.page.locator('#parts').getAttribute('aria-invalid')).toBe('true');
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
        const event = { dataTransfer, bubbles: true, cancelable: true };
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
    await studio.choose('ring.obj', objText(wavyRing(60)));
    await page.locator('#cancel').waitFor();
    await page.locator('#parts').press('Escape');
    await page.waitForTimeout(300);
    expect(await page.locator('#cancel').isVisible()).toBe(true);
    await page.locator('#cancel').press('Escape');
    await page.locator('#progress').waitFor({ state: 'hidden', timeout: 3000 });
    expect(studio.complaints).toEqual([]);
  }));
