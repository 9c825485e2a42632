/** How sheets are printed: the fields beside them, and what comes of it on the screen and in the files. */
import { readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { checkGuides } from '../web/guide-check.js';
import { readPdf } from '../web/pdf-file.js';
import { readSheet } from '../web/sheet-file.js';
import { useStudio } from './studio-fixture.js';
import type { StudioPage } from './studio-page.js';

const withStudio = useStudio();

const sample = readFileSync('dist/studio/samples/house.obj');

/** Unfolds a model with this name. */
async function unfold(studio: StudioPage, name: string): Promise<string> {
  // Few faces: the search is not what is looked at here.
  await studio.page.fill('#parts', '2');
  await studio.choose(`${name}.obj`, sample);
  return studio.resultOf(name);
}

const fontsOf = (studio: StudioPage) => studio.requests.filter((name) => name.endsWith('.woff'));

test('every field redraws the sheets at once, without another search', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    const hash = await unfold(studio, 'house');
    const cut = page.locator('.sheet [data-layer="cut"] path').first();
    const says = (words: string) => page.locator('.sheet text', { hasText: words }).first();
    const width = (value: string) =>
      page.locator(`.sheet [data-layer="cut"] [stroke-width="${value}"]`);

    await page.getByText('Colours, widths and dashes').click();
    await page.selectOption('#print-style', 'blender');
    await width('0.3').first().waitFor();
    await page.locator('.sheet [data-layer="flap"] [fill="#e6e6e6"]').first().waitFor();
    await page.selectOption('#print-style', 'pepakura');
    await width('0.15').first().waitFor();
    await page.fill('#cut-width', '0.4');
    await width('0.4').first().waitFor();
    await page.fill('#mountain-dash', '3 2');
    await page.locator('.sheet [stroke-dasharray="3 2"]').first().waitFor();
    await page.locator('#cut-colour').fill('#c02020');
    await page.locator('.sheet [stroke="#c02020"]').first().waitFor();
    await page.check('#print-angles');
    await says('°').waitFor();
    await page.getByLabel('only the ends of folds').check();
    await says('fold from mark to mark').waitFor();
    await page.getByLabel('only the ends of folds').uncheck();
    await says('fold from mark to mark').waitFor({ state: 'detached' });
    await says('mountain fold').waitFor();
    await page.uncheck('#print-legend');
    await says('mountain fold').waitFor({ state: 'detached' });
    await page.fill('#print-flat-fold', '180');
    await page.locator('.sheet [data-layer="cut"]').first().waitFor();
    await says('°').waitFor({ state: 'detached' });

    expect(await cut.getAttribute('stroke')).toBe('#c02020');
    expect(await page.locator('#result').getAttribute('data-hash')).toBe(hash);
    await studio.picture('print-1-fields');
    const svg = await studio.download('SVG');
    const text = svg.bytes.toString('latin1');
    if (svg.name.endsWith('.svg')) expect(text).toContain('stroke="#c02020" stroke-width="0.4"');
    expect(studio.complaints).toEqual([]);
  }));

test('colours on paper are chosen beside the sheets, and undone', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    const hash = await unfold(studio, 'house');
    const painted = page.locator('.sheet [data-layer="texture"] path').first();
    const colours = page.getByLabel('Colours on paper');
    expect(await colours.inputValue()).toBe('none');
    // The model has none of its own, and says so.
    expect(await page.locator('#print-colours-model').isDisabled()).toBe(true);
    await page.getByText('comes without colours').waitFor();
    await colours.selectOption('part');
    await painted.waitFor();
    await page.getByLabel('Coloured of each flap').selectOption('whole');
    await page.locator('.sheet [data-layer="flap"]').first().waitFor({ state: 'detached' });
    // Pieces are still chosen by a click.
    await page.locator('.sheet [data-area="A"]').click();
    await page.locator('.sheet [data-area="A"][data-selected]').waitFor();
    await studio.picture('print-4-colours');
    await page.getByLabel('Who cuts').selectOption('cricut');
    await painted.waitFor({ state: 'detached' });
    expect(await colours.isDisabled()).toBe(true);
    await page.locator('#undo').click();
    await painted.waitFor();
    expect(await colours.inputValue()).toBe('part');
    expect(await page.locator('#result').getAttribute('data-hash')).toBe(hash);
    expect(studio.complaints).toEqual([]);
  }));

test('light and shade of a model before it was simplified are printed on request, and undone', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await page.fill('#parts', '2');
    await page.fill('#faces', '60');
    await studio.choose('knot.obj', readFileSync('dist/studio/samples/knot.obj'));
    const hash = await studio.resultOf('knot');
    const printed = page.locator('.sheet [data-layer="texture"] image').first();
    const bleed = page.getByLabel('Coloured of each flap');
    expect(await bleed.isDisabled()).toBe(true);
    await page.getByLabel('light and shade of the model').check();
    await printed.waitFor();
    expect(await bleed.isDisabled()).toBe(false);
    await studio.picture('print-5-shading');
    await page.getByLabel('Who cuts').selectOption('generic');
    await printed.waitFor({ state: 'detached' });
    await page.locator('#undo').click();
    await printed.waitFor();
    await page.locator('#undo').click();
    await printed.waitFor({ state: 'detached' });
    expect(await page.locator('#result').getAttribute('data-hash')).toBe(hash);
    expect(studio.complaints).toEqual([]);
  }));

test('how lines look is part of the history, and stays for the next run', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await unfold(studio, 'house');
    const cuts = (width: string) =>
      page.locator(`.sheet [data-layer="cut"] [stroke-width="${width}"]`).first();
    await page.selectOption('#print-style', 'blender');
    await cuts('0.3').waitFor();
    await page.getByRole('button', { name: 'Undo: change of look' }).click();
    await cuts('0.3').waitFor({ state: 'detached' });
    expect(await page.locator('#print-style').inputValue()).toBe('foldwright');
    await page.locator('#redo').click();
    await cuts('0.3').waitFor();
    expect(await page.locator('#print-style').inputValue()).toBe('blender');
    // No lengths: a solid line.
    await page.getByText('Colours, widths and dashes').click();
    await page.fill('#mountain-dash', '');
    await page.locator('#mountain-dash').press('Tab');
    await page
      .locator('.sheet [data-layer="fold-mountain"] :not([stroke-dasharray])')
      .first()
      .waitFor();
    await unfold(studio, 'again');
    await cuts('0.3').waitFor();
    expect(await page.locator('#undo').isHidden()).toBe(true);
    expect(studio.complaints).toEqual([]);
  }));

test('a cover and steps come with a download when they are ticked, and undo takes the tick back', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await unfold(studio, 'house');
    const tick = page.getByLabel('with cover and building steps');
    const pagesOf = async () => {
      const { bytes } = await studio.download('PDF');
      return (await readPdf(new Uint8Array(bytes))).pages;
    };
    const sheets = await pagesOf();
    await tick.check();
    const undo = page.getByRole('button', { name: 'Undo: change of look' });
    await undo.waitFor();
    const all = await pagesOf();
    expect(all.length).toBeGreaterThanOrEqual(sheets.length + 2);
    expect(all[0]!.texts.map(({ text }) => text)).toContain('How to build it');
    // The sheets on the page are those to cut.
    expect(await page.locator('#sheets > li').count()).toBe(sheets.length);
    await undo.click();
    await undo.waitFor({ state: 'detached' });
    expect(await tick.isChecked()).toBe(false);
    expect(await pagesOf()).toHaveLength(sheets.length);
    await studio.picture('print-3-assembly');
    expect(studio.complaints).toEqual([]);
  }));

test('a PDF has folds on the backs of its sheets when that is ticked', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await unfold(studio, 'house');
    const sheets = await page.locator('#sheets > li').count();
    await page.getByLabel('folds on the back, too').check();
    await page.getByRole('button', { name: 'Undo: change of look' }).waitFor();
    const { bytes } = await studio.download('PDF');
    const { pages } = await readPdf(new Uint8Array(bytes));
    expect(pages).toHaveLength(2 * sheets);
    const words = pages[1]!.texts.map(({ text }) => text).join();
    expect(words).toContain(`back of sheet 1 of ${sheets}`);
    expect(await page.locator('#sheets > li').count()).toBe(sheets);
    expect(studio.complaints).toEqual([]);
  }));

test('sheets for a machine show what it does, and come without another search', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    const hash = await unfold(studio, 'house');
    await page.getByLabel('Who cuts').selectOption('silhouette');
    await page.locator('.sheet [data-layer="registration"]').first().waitFor();
    await page.locator('.sheet [data-layer="cut"] [stroke="#ff0000"]').first().waitFor();
    expect(await page.locator('.sheet [data-layer="guide"]').count()).toBe(0);
    expect(await page.locator('.sheet text').count()).toBe(0);
    expect(await page.locator('#machine-hint').innerText()).toContain('Red lines are cut');
    expect(await page.locator('#print-style').isDisabled()).toBe(true);
    await page.getByText('Colours, widths and dashes').click();
    await studio.picture('print-3-machine');
    const dxf = await studio.download('Machine (DXF)');
    if (dxf.name.endsWith('.dxf')) expect(dxf.bytes.toString('latin1')).toContain('REGISTRATION');

    await page.getByLabel('Who cuts').selectOption('cricut');
    await page.locator('.sheet [data-layer="registration"]').first().waitFor({ state: 'detached' });
    await page.getByLabel('Who cuts').selectOption('none');
    await page.locator('.sheet [data-layer="cut"] [stroke="#000000"]').first().waitFor();
    await page.locator('.sheet text', { hasText: 'print at 100 %' }).first().waitFor();
    expect(await page.locator('#print-style').isEnabled()).toBe(true);
    expect(await page.locator('#result').getAttribute('data-hash')).toBe(hash);
    expect(studio.complaints).toEqual([]);
  }));

test('pictures have the dots per inch that were asked for', () =>
  withStudio(async (studio) => {
    await unfold(studio, 'house');
    await studio.page.getByLabel('Dots per inch of pictures').fill('100');
    const { name, bytes } = await studio.download('Pictures (PNG)');
    if (name.endsWith('.png')) {
      const sides = [bytes.readUInt32BE(16), bytes.readUInt32BE(20)].sort((a, b) => a - b);
      expect(sides).toEqual([Math.ceil((210 / 25.4) * 100), Math.ceil((297 / 25.4) * 100)]);
    } else {
      expect(name).toBe('house-png.zip');
    }
    await studio.page.selectOption('#paper', 'A2');
    await unfold(studio, 'large');
    await studio.page.getByLabel('Dots per inch of pictures').fill('1200');
    await studio.page.getByRole('button', { name: 'Pictures (PNG)' }).click();
    expect(await studio.message()).toContain('1200 dots per inch are too many for sheets of');
    expect(studio.complaints).toEqual([]);
  }));

test('a measured printer is corrected, said so, and remembered', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await unfold(studio, 'house');
    expect(await page.locator('#measured-badge').isVisible()).toBe(false);
    await page.fill('#measured-across', '49.5');
    await page.fill('#measured-up', '50.2');
    await page
      .locator('.sheet text', { hasText: 'corrected for 49.5 × 50.2 mm' })
      .first()
      .waitFor();
    expect(await page.locator('#measured-badge').innerText()).toContain('49.5 × 50.2 mm');
    expect(await page.locator('#measured-state').innerText()).toContain('1.0 % longer across');
    const { pages } = await readPdf(new Uint8Array((await studio.download('PDF')).bytes));
    const factors: [number, number] = [50 / 49.5, 50 / 50.2];
    expect(
      checkGuides(
        pages.map(({ sheet }) => sheet),
        10,
        factors,
      ),
    ).toEqual([]);

    await page.reload();
    await page.locator('.sample').first().waitFor();
    await studio.unfoldSettings();
    await unfold(studio, 'again');
    await page.locator('#measured-badge').waitFor();
    await page.click('#measured-reset');
    await page.locator('#measured-badge').waitFor({ state: 'hidden' });
    const svg = await studio.download('SVG');
    if (svg.name.endsWith('.svg'))
      expect(checkGuides([readSheet(svg.bytes.toString())], 10)).toEqual([]);
    expect(studio.complaints).toEqual([]);
  }));

test('fonts come only when letters need them', () =>
  withStudio(async (studio) => {
    await unfold(studio, 'house');
    expect(fontsOf(studio)).toEqual([]);
    await studio.download('PDF');
    expect(fontsOf(studio)).toHaveLength(1);

    await unfold(studio, '折り紙 🐳');
    expect(fontsOf(studio).some((name) => name.includes('biz-udpgothic'))).toBe(true);
    expect(fontsOf(studio).length).toBeLessThan(6);
    expect(await studio.page.locator('#remarks').innerText()).toContain('No font has 🐳');
    const outlines = studio.page.locator('.sheet [data-text="折り紙 🐳"]');
    expect(await outlines.count()).toBeGreaterThan(0);
    const { pages } = await readPdf(new Uint8Array((await studio.download('PDF')).bytes));
    expect(pages[0]!.texts.map(({ text }) => text).join('')).toContain('折り紙');
    await studio.picture('print-2-japanese');
    expect(studio.complaints).toEqual([]);
  }));
