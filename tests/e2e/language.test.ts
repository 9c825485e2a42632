/** The page and its studio in another language than English. */
import { expect, test } from 'vitest';
import { loadWords } from '../../web/words/load.js';
import { objText } from '../web/model-text.js';
import { cube } from '../web/fixtures.js';
import { inLanguage } from './languages.js';
import { useStudio } from './studio-fixture.js';

const withStudio = useStudio();

test('the page begins in the language of the browser, and no word of another one is seen before', () =>
  withStudio(
    async ({ page, complaints }) => {
      const german = await loadWords('de');
      await page.locator('#start-title', { hasText: german.page.start.title }).waitFor();
      expect(await page.evaluate(() => document.documentElement.lang)).toBe('de');
      expect(await page.title()).toBe(german.site.title);
      expect(await page.getByText(german.site.tagline).count()).toBe(1);
      const seen = await page.evaluate(() => (window as unknown as { seen: string[] }).seen);
      expect(seen.filter((text) => /Choose a model|Print it/.test(text))).toEqual([]);
      expect(complaints).toEqual([]);
    },
    {
      script: `${inLanguage('de-AT')}
        window.seen = [];
        const attach = Element.prototype.attachShadow;
        Element.prototype.attachShadow = function (how) {
          const root = attach.call(this, how);
          const note = () => window.seen.push(root.textContent);
          new MutationObserver(note).observe(root, { childList: true, subtree: true });
          return root;
        };`,
    },
  ));

test('another language is chosen at the foot of the page, for the work on it and for later visits', () =>
  withStudio(
    async (studio) => {
      const { page } = studio;
      const german = await loadWords('de');
      const sheet = page.locator('#sheets svg').first();
      await studio.choose('cube.obj', objText(cube));
      const hash = await studio.resultOf('cube');
      expect(await sheet.textContent()).toContain('this side');
      await page.selectOption('#language', 'de');
      await page.locator('#print-open', { hasText: german.page.top.print }).waitFor();
      expect(await studio.resultOf('cube')).toBe(hash);
      expect(await sheet.textContent()).toContain(german.sheets.outside[0]);
      expect(await page.locator('#facts').textContent()).toContain(german.result.facts.size);
      await page.locator('#verdict-title', { hasText: /^[^a-z]*Du kannst|Bereit/ }).waitFor();
      await page.reload();
      await page.locator('#start-title', { hasText: german.page.start.title }).waitFor();
      await page.locator('#recent-go-on', { hasText: 'Weiter mit' }).waitFor();
      await page.selectOption('#language', 'en');
      await page.locator('#start-title', { hasText: 'Print it' }).waitFor();
      expect(studio.complaints).toEqual([]);
    },
    { viewport: { width: 1366, height: 900 } },
  ));

test('what the document is about is the same in every language', () =>
  withStudio(
    async (studio) => {
      const { page } = studio;
      await studio.choose('cube.obj', objText(cube));
      await studio.resultOf('cube');
      expect((await studio.download('FOLD')).bytes.toString()).toContain('"Piece A"');
      const svg = (await studio.download('SVG')).bytes.toString();
      expect(svg).toContain('Blatt 1 von 1');
      expect(await page.locator('#announcement').textContent()).toMatch(/^Fertig: /);
    },
    { script: inLanguage('de') },
  ));
