/** From a model to its files, as a visitor does it. */
import { unzipSync } from 'fflate';
import { expect, test } from 'vitest';
import { cube } from '../web/fixtures.js';
import { checkFold } from '../web/fold-check.js';
import { parseFold } from '../web/fold-file.js';
import { objText, wavyRing } from '../web/model-text.js';
import { useStudio } from './studio-fixture.js';
import { wellFormed } from './well-formed.js';

const withStudio = useStudio();

test('a sample becomes nets on sheets, and all three files are real', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await page.fill('#parts', '2');
    await studio.chooseSample('Heart');
    await studio.resultOf('heart');
    // Its materials have come along.
    expect(await page.locator('#looks').isVisible()).toBe(true);
    expect(await page.locator('.sheet [data-layer="texture"]').count()).toBeGreaterThan(0);
    const sheets = await page.locator('.sheet svg').count();
    expect(sheets).toBeGreaterThan(0);
    expect(await page.locator('.sheet [data-layer="cut"] path').count()).toBeGreaterThan(0);
    expect(await page.locator('#result-lead').innerText()).toMatch(/^2 parts\b.* sheets? of A4\.$/);

    const pdf = await studio.download('PDF');
    expect(pdf.name).toBe('heart.pdf');
    expect(pdf.bytes.subarray(0, 4).toString()).toBe('%PDF');

    const svg = await studio.download('SVG');
    const files = sheets === 1 ? [svg.bytes] : Object.values(unzipSync(new Uint8Array(svg.bytes)));
    expect(files).toHaveLength(sheets);
    for (const file of files) {
      expect(await wellFormed(page, Buffer.from(file).toString())).toBe('svg');
    }

    const fold = await studio.download('FOLD');
    expect(fold.name).toBe('heart.fold');
    expect(checkFold(parseFold(fold.bytes.toString()))).toEqual([]);

    expect(studio.complaints).toEqual([]);
  }));

test('nothing is asked of any other machine', () =>
  withStudio(async (studio) => {
    await studio.chooseSample('House');
    await studio.resultOf('house');
    await studio.download('PDF');
    const hosts = new Set(studio.requests.map((address) => new URL(address).hostname));
    // Downloads come from blob: addresses, which have no host.
    hosts.delete('');
    expect([...hosts]).toEqual(['localhost']);
  }));

test('the engine works in a worker, and the page answers while it does', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await page.fill('#parts', '1');
    await studio.choose('ring.obj', objText(wavyRing(30)));
    await page.locator('#cancel').waitFor();
    // Pictures are drawn by workers of other kinds.
    const engines = (): number =>
      page.workers().filter((worker) => worker.url().includes('/worker-')).length;
    await expect.poll(engines).toBeGreaterThan(0);
    // The module is compiled where it runs: the page's own thread must not ask for it.
    const own = await page.evaluate(() =>
      performance.getEntriesByType('resource').filter(({ name }) => name.endsWith('.wasm')),
    );
    expect(own).toEqual([]);
    await page.selectOption('#paper', 'Letter');
    expect(await page.inputValue('#paper')).toBe('Letter');
    await page.locator('#cancel').click();
  }));

test('which way is up and how deep the model gets can be asked for', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await page.selectOption('#up', 'z');
    await page.selectOption('#sizing', 'depth');
    await page.fill('#size', '20');
    // 60 x 40 x 100 in the file.
    const vertices = cube.vertices.map(([x, y, z]) => [1.5 * x!, y!, 2.5 * z!]);
    await studio.choose('box.obj', objText({ ...cube, vertices }));
    await studio.resultOf('box');
    expect(await page.getByText('30 × 50 × 20 mm').isVisible()).toBe(true);
    expect(studio.complaints).toEqual([]);
  }));

test('what is hard to build is said before anything is printed', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await page.fill('#parts', '1');
    await page.selectOption('#sizing', 'height');
    await page.fill('#size', '8');
    await studio.choose('small.obj', objText(cube));
    await studio.resultOf('small');
    const verdict = await page.locator('#verdict').innerText();
    expect(verdict).toContain('Half of all edges are at most 8 mm long: a fingertip needs 12 mm.');
    const glue = page.locator('#facts div').filter({ hasText: 'To glue' });
    expect(await glue.locator('dd').innerText()).toBe('0.1 m on 7 seams');
  }));

test('parts and paper can be asked for', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await page.fill('#parts', '3');
    await page.selectOption('#paper', 'Letter');
    await page.selectOption('#orientation', 'landscape');
    await studio.chooseSample('Duck');
    await studio.resultOf('duck');
    expect(await page.locator('#result-lead').innerText()).toMatch(/^3 parts.* of Letter\.$/);
    const svg = page.locator('.sheet svg').first();
    expect(await svg.getAttribute('viewBox')).toBe('0 0 279.4 215.9');
  }));

test('a dropped model is unfolded, and its name stays text', () =>
  withStudio(async (studio) => {
    const name = '<img src=x onerror=alert(1)>.obj';
    await studio.drop([{ name, content: objText(wavyRing(6)) }]);
    await studio.resultOf('<img src=x');
    expect(await studio.page.locator('#result img').count()).toBe(0);
    expect(studio.complaints).toEqual([]);
  }));

test('the keyboard alone is enough', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await page.getByRole('button', { name: 'Cube', exact: true }).focus();
    await page.keyboard.press('Enter');
    await studio.resultOf('cube');
    await page.locator('#unfold').focus();
    await page.keyboard.press('Space');
    await studio.resultOf('cube');
  }));
