/** The pages as they will be printed: what the print view shows, prints and saves. */
import { unzipSync } from 'fflate';
import { PDFDocument } from 'pdf-lib';
import type { Page } from 'playwright-core';
import { expect, test } from 'vitest';
import { objText, wavyRing } from '../web/model-text.js';
import { useStudio } from './studio-fixture.js';
import type { StudioPage } from './studio-page.js';

const withStudio = useStudio();

/** A document that was handed to the browser's dialogue. */
interface Printed {
  body: string;
  css: string;
}

// There is no printer: what would go to the dialogue is kept, whichever frame asks.
const script = `window.print = () => {
  const css = document.adoptedStyleSheets.flatMap(({ cssRules }) => [...cssRules].map((rule) => rule.cssText)).join('\\n');
  (top.printed ??= []).push({ body: document.body.innerHTML, css });
  window.dispatchEvent(new Event('afterprint'));
};`;

/** Some sheets, upright. */
async function open(studio: StudioPage): Promise<number> {
  const { page } = studio;
  await page.fill('#parts', '3');
  await page.selectOption('#sizing', 'height');
  await page.fill('#size', '300');
  await page.selectOption('#orientation', 'portrait');
  await studio.choose('ring.obj', objText(wavyRing(12)));
  await studio.resultOf('ring');
  await page.locator('#print-open').click();
  await page.locator('.print-page').first().waitFor();
  return page.locator('.print-page').count();
}

async function printed(page: Page): Promise<Printed> {
  const documents = () =>
    page.evaluate(() => (window as unknown as { printed?: Printed[] }).printed ?? []);
  const { length } = await documents();
  await page.getByRole('button', { name: 'Print at true size' }).click();
  await expect.poll(async () => (await documents()).length).toBe(length + 1);
  return (await documents())[length]!;
}

/** What Chromium makes of a document on paper: the size of its pages in mm, and where their pictures lie. */
async function onPaper(page: Page, { body, css }: Printed) {
  const other = await page.context().newPage();
  try {
    await other.evaluate(
      async ([content, rules]) => {
        document.body.innerHTML = content;
        const style = new CSSStyleSheet();
        style.replaceSync(rules);
        document.adoptedStyleSheets = [style];
        await Promise.all([...document.images].map((image) => image.decode()));
      },
      [body, css] as const,
    );
    await other.emulateMedia({ media: 'print' });
    const pictures = await other.locator('img').evaluateAll((images) =>
      images.map((image) => {
        const { width, height } = image.getBoundingClientRect();
        return [width, height].map((pixels) => (pixels * 25.4) / 96);
      }),
    );
    const pdf = await PDFDocument.load(await other.pdf({ preferCSSPageSize: true }));
    const pages = pdf
      .getPages()
      .map((one) => [one.getWidth(), one.getHeight()].map((points) => (points * 25.4) / 72));
    return { pages, pictures, bytes: await pdf.save() };
  } finally {
    await other.close();
  }
}

test('each page is printed at the true size of its sheet, and nothing else is', () =>
  withStudio(
    async (studio) => {
      const { page } = studio;
      const count = await open(studio);
      expect(count).toBeGreaterThan(2);
      await studio.picture('print-view');
      const { pages, pictures } = await onPaper(page, await printed(page));
      expect(pages).toHaveLength(count);
      for (const [width, height] of pages) {
        // A browser counts paper in whole pixels, of which one is a quarter of a mm.
        expect(Math.abs(width! - 210)).toBeLessThan(0.27);
        expect(Math.abs(height! - 297)).toBeLessThan(0.27);
      }
      for (const [width, height] of pictures) {
        expect(width).toBeCloseTo(210, 1);
        expect(height).toBeCloseTo(297, 1);
      }
      // The document that was printed is gone again.
      await expect.poll(() => page.locator('.print-frame').count()).toBe(0);
      expect(studio.complaints).toEqual([]);
    },
    { script },
  ));

test('some sheets only are shown, printed and saved, and a number that makes no sense is explained', () =>
  withStudio(
    async (studio) => {
      const { page } = studio;
      const count = await open(studio);
      const hint = page.locator('#print-range-words');
      await page.fill('#print-range', '2-3');
      await expect.poll(() => page.locator('.print-page').count()).toBe(2);
      expect(await hint.innerText()).toBe(`2 of ${count} sheets`);
      expect(await page.locator('.print-page figcaption').first().innerText()).toBe(
        `Sheet 2 of ${count}, 210 × 297 mm`,
      );
      const document = await printed(page);
      expect(document.body.match(/<img/g)).toHaveLength(2);
      const svg = await studio.download('SVG');
      const files = Object.entries(unzipSync(new Uint8Array(svg.bytes)));
      expect(files.map(([name]) => name)).toEqual(['ring-2.svg', 'ring-3.svg']);
      // To the letter what is printed.
      for (const [, bytes] of files) {
        expect(document.body).toContain(encodeURIComponent(Buffer.from(bytes).toString()));
      }
      const pdf = await studio.download('PDF');
      expect((await PDFDocument.load(pdf.bytes)).getPageCount()).toBe(2);

      await page.fill('#print-range', '9-99');
      expect(await hint.innerText()).toBe(`There are sheets 1 to ${count}`);
      expect(await page.locator('#print-now').isDisabled()).toBe(true);
      await page.fill('#print-range', 'one');
      expect(await hint.innerText()).toBe('Write numbers, like 1-3, 5');
      // Back on the bench all sheets are saved.
      await page.fill('#print-range', '1');
      await page.getByRole('button', { name: 'Back to the bench' }).click();
      const whole = await studio.download('PDF');
      expect((await PDFDocument.load(whole.bytes)).getPageCount()).toBe(count);
      expect(studio.complaints).toEqual([]);
    },
    { script },
  ));

test('the look of lines shows on the pages, and Escape leads back to where one was', () =>
  withStudio(
    async (studio) => {
      const { page } = studio;
      await open(studio);
      const first = page.locator('.print-page img').first();
      const before = await first.getAttribute('src');
      await page.selectOption('#print-style', 'pepakura');
      await expect.poll(() => first.getAttribute('src')).not.toBe(before);
      await page.check('#print-assembly');
      await page.locator('.print-page', { hasText: 'How to build it' }).first().waitFor();
      expect(await page.locator('#verdict-title').isVisible()).toBe(true);
      expect(await page.locator('#sheets').isVisible()).toBe(false);
      await page.locator('#print-now').focus();
      await page.keyboard.press('Escape');
      expect(await page.locator('#print-view').isVisible()).toBe(false);
      expect(await page.locator('#sheets').isVisible()).toBe(true);
      expect(await page.locator('#print-open').evaluate((own) => own.matches(':focus'))).toBe(true);
      // Another model leaves it, too.
      await page.keyboard.press('Enter');
      await page.locator('.print-page').first().waitFor();
      await page.keyboard.press('Control+p');
      await expect
        .poll(() => page.evaluate(() => (window as unknown as { printed?: [] }).printed?.length))
        .toBe(1);
      expect(studio.complaints).toEqual([]);
    },
    { script },
  ));
