/** What a person does with a result, in every engine: paper, edits, undo, names, a reload, and printing. */
import { expect, test } from 'vitest';
import { kept } from '../e2e/kept-work.js';
import { coloursIn } from './colours.js';
import { engines, useEngines } from './engines-fixture.js';
import type { WatchedStudio } from './watched-studio.js';

const withStudio = useEngines();

/** A picture that shows nothing has one colour; edges smoothed by the browser make many. */
const few = 20;

/** Waits until the browser has kept a result. */
function untilKept(studio: WatchedStudio, hash: string): Promise<true> {
  return studio.poll('kept result', async () => {
    const [first] = await kept(studio.page);
    return first?.hashes[first.cursor] === hash ? true : null;
  });
}

/** Waits until an element shows a picture. */
function untilDrawn(studio: WatchedStudio, selector: string): Promise<number> {
  return studio.poll(`picture in ${selector}`, async () => {
    const box = await studio.placeOf(selector);
    const colours = coloursIn(await studio.page.screenshot(), box);
    return colours > few ? colours : null;
  });
}

/** Clicks a fold that is drawn on the sheets. */
async function clickFold(studio: WatchedStudio): Promise<void> {
  const place = await studio.page.evaluate(() => {
    const [fold] = window.seen('[data-layer="fold-mountain"] :is(path, line)');
    fold!.scrollIntoView({ block: 'center', inline: 'center' });
    const svg = fold as SVGGeometryElement;
    const { x, y } = svg
      .getPointAtLength(svg.getTotalLength() / 2)
      .matrixTransform(svg.getScreenCTM()!);
    return [x, y] as const;
  });
  await studio.page.click(...place);
}

test.each(engines)('a house is made in $name', (engine) =>
  withStudio(engine, async (studio) => {
    const { page } = studio;
    await studio.picture('1-start');
    await studio.click('.sample', 'House');
    const first = await studio.result();
    await untilDrawn(studio, '#model-picture');
    await studio.picture('2-result');
    // Drawn by a worker, more than once: while it was hidden, and now.
    await studio.click('summary', 'How it was found');
    await studio.reveal('#net');
    await untilDrawn(studio, '#net');

    await studio.unfold('#settings');
    await studio.choose('#paper', 'A5');
    await studio.click('button', 'Apply and unfold again');
    const small = await studio.result(first);
    await studio.until('#result-lead', 'of A5');

    await clickFold(studio);
    await studio.until('#edge-words', 'Mountain fold');
    await studio.click('#edge-card button', 'Cut here');
    const cut = await studio.result(small);
    await studio.picture('3-cut');
    await studio.click('#undo');
    expect(await studio.result(cut)).toBe(small);
    await page.press('Escape');

    await studio.write('.part__name', 'Roof');
    await page.press('Enter');
    await studio.until('#announcement', 'Named Roof.');
    const named = await studio.result();

    await untilKept(studio, named);
    expect(await studio.complaints()).toEqual([]);
    await page.reload();
    await studio.click('#recent-go-on');
    expect(await studio.result()).toBe(named);
    await studio.until('.sheet text', 'Roof');
    await studio.click('#undo', 'name of part 1');
    await studio.until('#announcement', 'Undone');

    await studio.click('#print-open');
    await studio.until('.print-page');
    await studio.picture('4-print');
    await studio.click('#print-now');
    const { widths } = await studio.poll('printed document', () =>
      page.evaluate(() => window.printed[0] ?? null),
    );
    expect(widths.length).toBeGreaterThan(0);
    expect(Math.min(...widths)).toBeGreaterThan(0);
    await studio.click('#print-close');

    await page.resize(390, 844);
    for (const tab of ['Model', 'Sheets', 'Build', 'Save']) {
      await studio.click('[role="tab"]', tab);
      await studio.picture(`5-phone-${tab.toLowerCase()}`);
      expect([tab, await studio.overflow()]).toEqual([tab, 0]);
    }
    expect(await studio.complaints()).toEqual([]);
  }),
);
