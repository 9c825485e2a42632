/** Pieces on the sheets are pointed at, chosen, moved, turned and kept in place. */
import type { Page } from 'playwright-core';
import { expect, test } from 'vitest';
import { objText, wavyRing } from '../web/model-text.js';
import { pointInside } from './sheet-points.js';
import { useStudio } from './studio-fixture.js';
import { phone, type StudioPage } from './studio-page.js';

const withStudio = useStudio();

const button = (page: Page, name: string) => page.getByRole('button', { name });
const words = (page: Page) => page.locator('#piece-words').innerText();
const outcome = (page: Page) => page.locator('#piece-outcome').innerText();
const undo = (page: Page) => page.locator('#undo').textContent();
const piece = (name: string) => `[data-area="${name}"]`;

/** Six pieces on one sheet. */
async function open(studio: StudioPage): Promise<string> {
  await studio.page.fill('#parts', '6');
  await studio.chooseSample('Whale');
  return studio.resultOf('whale');
}

/** The hash of the result that a change leads to. */
async function changed(studio: StudioPage, before: string): Promise<string> {
  const other = studio.page.locator(`#result:not([data-hash="${before}"])`);
  await other.waitFor({ timeout: 60_000 });
  return studio.resultOf('whale');
}

const hashOf = (page: Page) => page.locator('#result').getAttribute('data-hash');

async function click(page: Page, name: string): Promise<void> {
  await page.mouse.click(...(await pointInside(page, piece(name))));
}

type Place = [sheet: number, x: number, y: number];

/** Where each piece lies: its sheet from 0, and the corner of its box there in mm. */
async function boxes(page: Page): Promise<Record<string, Place>> {
  const places = await page.locator('.sheet').evaluateAll((sheets) =>
    sheets.flatMap((sheet, index) =>
      [...sheet.querySelectorAll<SVGPathElement>('[data-area]')].map((area) => {
        const { x, y } = area.getBBox();
        const place: Place = [index, Math.round(x), Math.round(y)];
        return [area.dataset['area'] ?? '', place] as const;
      }),
    ),
  );
  return Object.fromEntries(places);
}

/** Puts a piece on a sheet of its own and waits for it. */
async function toNewSheet(studio: StudioPage, name: string): Promise<string> {
  const { page } = studio;
  const before = (await hashOf(page)) ?? '';
  await click(page, name);
  await page.locator('#piece-card summary').click();
  await page.selectOption('#piece-sheet', { label: 'a new one' });
  const after = await changed(studio, before);
  await page.locator('#piece-card summary').click();
  return after;
}

test('a piece under the pointer is lit and named, and a click opens its card over the sheets', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await open(studio);
    await pointInside(page, piece('B'));
    expect(await page.locator('#piece-line').innerText()).toMatch(
      /^Piece B: \d+ × \d+ mm, sheet 1, \d+ faces$/,
    );
    expect(await page.locator('[data-pointed]').getAttribute('data-area')).toBe('B');
    const place = await page.locator('#sheets').boundingBox();
    await click(page, 'B');
    expect(await words(page)).toMatch(/^Piece B: /);
    expect(await page.locator('[data-chosen]').getAttribute('data-area')).toBe('B');
    expect(await page.locator('#sheets').boundingBox()).toEqual(place);
    await studio.picture('pieces-card');
    // An edge takes the place of the card.
    await page.fill('#edge-number', '1');
    await page.locator('#edge-number').press('Enter');
    expect(await page.locator('#piece-card').isHidden()).toBe(true);
    expect(await page.locator('#edge-card').isVisible()).toBe(true);
    await page.fill('#edge-number', 'c');
    await page.locator('#edge-number').press('Enter');
    expect(await words(page)).toMatch(/^Piece C: /);
    expect(await page.locator('#edge-card').isHidden()).toBe(true);
    await page.fill('#edge-number', 'Z9');
    await page.locator('#edge-number').press('Enter');
    expect(await page.locator('#edge-words').innerText()).toBe(
      'No edge and no piece is called Z9.',
    );
    expect(await page.locator('#piece-card').isHidden()).toBe(true);
    expect(studio.complaints).toEqual([]);
  }));

test('a piece is dragged on its sheet and to another one, and refused where it cannot lie', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await open(studio);
    const first = await toNewSheet(studio, 'B');
    expect(await page.locator('#result-lead').innerText()).toMatch(/2 sheets/);
    const before = await boxes(page);
    expect(before['B']![0]).toBe(1);
    await page.keyboard.press('Escape');

    const [x, y] = await pointInside(page, piece('B'));
    const scroll = await page.evaluate(() => scrollY);
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x - 40, y + 30, { steps: 4 });
    await page.locator('.ghost--free').waitFor();
    // Escape puts it back.
    await page.keyboard.press('Escape');
    expect(await page.locator('.ghost').count()).toBe(0);
    await page.mouse.up();
    expect(await hashOf(page)).toBe(first);

    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x - 40, y + 30, { steps: 4 });
    await page.locator('.ghost--free').waitFor();
    await page.mouse.up();
    const moved = await changed(studio, first);
    const after = await boxes(page);
    expect(after['B']).not.toEqual(before['B']);
    // All others stay, nothing was selected, and the page stands still.
    expect({ ...after, B: null }).toEqual({ ...before, B: null });
    expect(await page.evaluate(() => String(getSelection()))).toBe('');
    expect(await page.evaluate(() => scrollY)).toBe(scroll);
    expect(await undo(page)).toBe('Undo: moved B');
    expect(await page.locator('#announcement').innerText()).toBe('Moved B.');

    // Beyond the edge of the paper, and on another piece.
    const [u, v] = await pointInside(page, piece('B'));
    await page.mouse.move(u, v);
    await page.mouse.down();
    const paper = (await page.locator('.sheet').nth(1).locator('svg').boundingBox())!;
    await page.mouse.move(u, paper.y + 1, { steps: 4 });
    await page.locator('.ghost--refused').waitFor();
    await studio.picture('pieces-refused');
    await page.mouse.up();
    expect(await outcome(page)).toBe(
      'B is back where it was. There, it would be too near to the edge of the sheet to be printed.',
    );
    expect(await hashOf(page)).toBe(moved);
    await page.keyboard.press('Escape');

    await page.locator('#zoom').fill('240');
    const [s, t] = await pointInside(page, piece('B'));
    const [a, b] = await page.locator(piece('A')).evaluate((path) => {
      const { left, top, width, height } = path.getBoundingClientRect();
      return [left + width / 2, top + height / 2] as const;
    });
    await page.mouse.move(s, t);
    await page.mouse.down();
    await page.mouse.move(a, b, { steps: 6 });
    await page.locator('.ghost--refused').waitFor();
    await page.mouse.up();
    expect(await outcome(page)).toBe('B is back where it was. There, it would lie on A.');
    expect(await hashOf(page)).toBe(moved);
    expect(studio.complaints).toEqual([]);
  }));

test('a dragged piece is turned by a key and laid on another sheet', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await open(studio);
    await toNewSheet(studio, 'B');
    const two = await toNewSheet(studio, 'C');
    await page.keyboard.press('Escape');
    await page.locator('#zoom').fill('240');
    const [x, y] = await pointInside(page, piece('C'));
    const other = await page.locator('.sheet').nth(1).locator('svg').boundingBox();
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 10, y, { steps: 2 });
    await page.keyboard.press('r');
    // To the end of the sheet of B where it leaves room.
    const b = (await page.locator(piece('B')).boundingBox())!;
    const isHigh = b.y - other!.y > other!.height / 2;
    const free = isHigh ? other!.y + 0.25 * other!.height : other!.y + 0.75 * other!.height;
    await page.mouse.move(other!.x + other!.width / 2, free, { steps: 6 });
    await page.locator('.ghost--free').waitFor();
    await page.mouse.up();
    await changed(studio, two);
    const after = await boxes(page);
    expect([after['B']![0], after['C']![0]]).toEqual([1, 1]);
    expect(await undo(page)).toBe('Undo: turned C');
    // The sheet that it left is gone, and undo brings it back.
    expect(await page.locator('.sheet').count()).toBe(2);
    await page.keyboard.press('Control+z');
    await page.locator('.sheet').nth(2).waitFor();
    expect(await page.locator('#redo').textContent()).toBe('Redo: turned C');
    expect(studio.complaints).toEqual([]);
  }));

test('the keyboard alone walks the pieces, moves and turns one, and lets it go again', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await open(studio);
    const first = await toNewSheet(studio, 'C');
    await page.keyboard.press('Escape');
    // From the size of the sheets past the buttons that fit them.
    await page.locator('#zoom').focus();
    for (let i = 0; i < 3; ++i) await page.keyboard.press('Tab');
    expect(await page.locator('#sheets').evaluate((own) => own.matches(':focus'))).toBe(true);
    await page.keyboard.press('ArrowRight');
    expect(await page.locator('#piece-said').textContent()).toMatch(/^Piece A: /);
    // Before the first one comes the last.
    await page.keyboard.press('ArrowLeft');
    expect(await page.locator('[data-pointed]').getAttribute('data-area')).toBe('F');
    for (let i = 0; i < 3; ++i) await page.keyboard.press('ArrowRight');
    expect(await page.locator('[data-pointed]').getAttribute('data-area')).toBe('C');
    await page.keyboard.press('Enter');
    expect(await words(page)).toMatch(/^Piece C: .* sheet 2,/);
    const before = await boxes(page);
    // Several steps are one change; to the left, since it may have come from the right edge of its sheet.
    await page.keyboard.press('Shift+ArrowLeft');
    await page.keyboard.press('ArrowLeft');
    await page.keyboard.press('Shift+ArrowDown');
    const moved = await changed(studio, first);
    const after = await boxes(page);
    const [, fromX, fromY] = before['C']!;
    expect(after['C']).toEqual([1, fromX - 11, fromY + 10]);
    expect(await undo(page)).toBe('Undo: moved C');
    expect(await page.locator('#piece-card').evaluate((own) => own.matches(':focus-within'))).toBe(
      true,
    );

    await button(page, 'Turn left by 5°').focus();
    await page.keyboard.press('Enter');
    await page.keyboard.press('Enter');
    const turned = await changed(studio, moved);
    expect(await undo(page)).toBe('Undo: turned C');
    await page.keyboard.press('Control+z');
    expect(await changed(studio, turned)).toBe(moved);
    await page.keyboard.press('Control+z');
    expect(await changed(studio, moved)).toBe(first);

    await button(page, 'Let it move').focus();
    await page.keyboard.press('Enter');
    await expect.poll(() => undo(page)).toBe('Undo: let C move');
    await expect.poll(() => page.locator('.pin-sign').count()).toBe(0);
    await button(page, 'Keep it here').focus();
    await page.keyboard.press('Enter');
    await expect.poll(() => undo(page)).toBe('Undo: kept C in place');
    await expect.poll(() => page.locator('.pin-sign').count()).toBe(1);
    await studio.picture('pieces-pinned');
    // Out of the card, back to the sheets.
    await page.keyboard.press('Escape');
    expect(await page.locator('#piece-card').isHidden()).toBe(true);
    expect(await page.locator('#sheets').evaluate((own) => own.matches(':focus'))).toBe(true);
    expect(studio.complaints).toEqual([]);
  }));

test('a piece gets another net, a name and a neighbour, while others stay', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    const first = await open(studio);
    const before = await boxes(page);
    await click(page, 'D');
    await page.locator('#piece-card summary').click();
    await button(page, 'Look for another net').click();
    await changed(studio, first);
    const { D: _, ...others } = await boxes(page);
    expect(before).toMatchObject(others);
    expect(await words(page)).toMatch(/^Piece D: /);
    expect(await undo(page)).toMatch(/^Undo: another net for part/);

    await page.fill('#piece-name', 'Tail');
    await page.locator('#piece-name').press('Enter');
    await expect.poll(() => words(page)).toMatch(/^Piece Tail: /);

    // A fin touches the body alone.
    const offers = await page.locator('#piece-partner option').allInnerTexts();
    expect(offers).toEqual(['A']);
    const named = (await hashOf(page)) ?? '';
    await page.selectOption('#piece-partner', { label: offers[0]! });
    await button(page, 'Join').click();
    await changed(studio, named);
    expect(await page.locator('#result-lead').innerText()).toMatch(/^5 parts/);
    expect(studio.complaints).toEqual([]);
  }));

test('where a turned piece has no room it is drawn in red, until it is put where there is some', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    const first = await open(studio);
    await click(page, 'C');
    // Far enough to leave the sheet, wherever it lies.
    for (let i = 0; i < 30; ++i) await button(page, 'Move up').click({ modifiers: ['Shift'] });
    expect(await outcome(page)).toBe(
      'C cannot stay here: it would be too near to the edge of the sheet to be printed.',
    );
    expect(await page.locator('.ghost--refused').count()).toBe(1);
    await page.waitForTimeout(1000);
    expect(await hashOf(page)).toBe(first);
    await button(page, 'Put it where there is room').click();
    await expect.poll(() => page.locator('.ghost').count()).toBe(0);
    const other = await changed(studio, first);
    expect(await undo(page)).toMatch(/^Undo: (moved|turned) C$/);
    await page.keyboard.press('Control+z');
    expect(await changed(studio, other)).toBe(first);
    expect(studio.complaints).toEqual([]);
  }));

test('a finger chooses a piece by a tap and then drags it, while the page stands still', () =>
  withStudio(
    async (studio) => {
      const { page } = studio;
      await open(studio);
      await studio.showTab('Sheets');
      const first = await toNewSheet(studio, 'B');
      await page.keyboard.press('Escape');
      const [x, y] = await pointInside(page, piece('B'));
      await page.touchscreen.tap(x, y);
      expect(await words(page)).toMatch(/^Piece B: /);
      const scroll = await page.evaluate(() => scrollY);
      const devtools = await page.context().newCDPSession(page);
      const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', dx: number, dy: number) =>
        devtools.send('Input.dispatchTouchEvent', {
          type,
          touchPoints: type === 'touchEnd' ? [] : [{ x: x + dx, y: y + dy }],
        });
      await touch('touchStart', 0, 0);
      for (const step of [5, 10, 15, 20]) await touch('touchMove', -step, step);
      await page.locator('.ghost').waitFor();
      expect(await page.locator('#piece-card').isHidden()).toBe(true);
      await touch('touchEnd', -20, 20);
      await devtools.detach();
      await changed(studio, first);
      expect(await undo(page)).toBe('Undo: moved B');
      expect(await page.evaluate(() => scrollY)).toBe(scroll);
      await studio.picture('pieces-phone');
      expect(studio.complaints).toEqual([]);
    },
    { viewport: phone, hasTouch: true },
  ));

test('the model and the sheets light each other’s pieces', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await page.fill('#parts', '2');
    await studio.choose('ring.obj', objText(wavyRing(12)));
    await studio.resultOf('ring');
    await studio.drawn('#model-picture');
    const box = (await page.locator('#model-picture').boundingBox())!;
    // The ring is seen from the front, and as large as the picture allows: its tube is left of the middle.
    const side = Math.min(box.width, box.height);
    const [x, y] = [box.x + 0.5 * box.width - 0.27 * side, box.y + 0.5 * box.height];
    await page.mouse.move(x, y);
    await page.locator('[data-pointed]').waitFor();
    const name = (await page.locator('[data-pointed]').getAttribute('data-area'))!;
    await page.mouse.click(x, y);
    await expect.poll(() => words(page)).toMatch(new RegExp(`^Piece ${name}: `));
    await page.mouse.move(box.x + 2, box.y + 2);
    await page.locator('[data-pointed]').waitFor({ state: 'detached' });
    await page.keyboard.press('Escape');
    await page.waitForTimeout(500);
    const plain = await page.locator('#model-picture').screenshot();
    await pointInside(page, piece(name));
    await page.locator('#model-picture').scrollIntoViewIfNeeded();
    await expect
      .poll(async () => plain.equals(await page.locator('#model-picture').screenshot()))
      .toBe(false);
    expect(studio.complaints).toEqual([]);
  }));

test('all flaps of a piece go to its neighbours and come back in one step', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    const first = await open(studio);
    await click(page, 'B');
    await page.locator('#piece-card summary').click();
    await button(page, 'All on the others').click();
    const others = await changed(studio, first);
    expect(await undo(page)).toBe('Undo: flaps of B');
    await studio.picture('pieces-flaps');
    await button(page, 'None').click();
    expect(await changed(studio, others)).not.toBe(first);
    await button(page, 'Undo: flaps of B').click();
    await button(page, 'Undo: flaps of B').click();
    await page.locator(`#result[data-hash="${first}"]`).waitFor();
    expect(studio.complaints).toEqual([]);
  }));
