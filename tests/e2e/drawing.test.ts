/** Pictures are drawn where that leaves the page free, and where they can be drawn at all. */
import { expect, test } from 'vitest';
import { useStudio } from './studio-fixture.js';

const withStudio = useStudio();

/** Notes which kinds of drawing the page's own thread asks for. */
const noteContexts = `globalThis.contexts = [];
  const getContext = HTMLCanvasElement.prototype.getContext;
  HTMLCanvasElement.prototype.getContext = function (kind, ...options) {
    contexts.push(kind);
    return getContext.call(this, kind, ...options);
  };`;

test('all pictures are drawn by workers', () =>
  withStudio(
    async (studio) => {
      const { page } = studio;
      // A heart in one part is not learned about, and has no matrix.
      await page.fill('#parts', '3');
      await studio.chooseSample('Heart');
      await studio.resultOf('heart');
      await page.getByText('How it was found').click();
      for (const canvas of ['#model-picture', '#matrix', '#net']) await studio.drawn(canvas);
      const contexts = await page.evaluate(
        () => (globalThis as unknown as { contexts: string[] }).contexts,
      );
      expect(contexts).toEqual([]);
      expect(studio.complaints).toEqual([]);
    },
    { script: noteContexts },
  ));

test('where workers cannot draw, the page does', () =>
  withStudio(
    async (studio) => {
      await studio.page.fill('#parts', '3');
      await studio.chooseSample('Heart');
      await studio.resultOf('heart');
      await studio.page.getByText('How it was found').click();
      for (const canvas of ['#model-picture', '#matrix', '#net']) await studio.drawn(canvas);
      expect(studio.complaints).toEqual([]);
    },
    { script: 'delete HTMLCanvasElement.prototype.transferControlToOffscreen;' },
  ));

test('without WebGL the page says so and does all the rest', () =>
  withStudio(
    async (studio) => {
      await studio.chooseSample('Cube');
      await studio.resultOf('cube');
      await studio.page.getByText('no WebGL 2').waitFor();
      expect(studio.requests.some((address) => address.includes('model-scene'))).toBe(false);
      expect(studio.complaints).toEqual([]);
    },
    { flags: ['--use-gl=disabled'] },
  ));

test('parts can be told apart by hatches', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await studio.chooseSample('Heart');
    await studio.resultOf('heart');
    // Sheets in the colours of the model show no parts.
    await page.getByLabel('Colours on paper').selectOption('none');
    await page.locator('.sheet [data-layer="texture"]').first().waitFor({ state: 'detached' });
    expect(await page.locator('.sheet .hatch').first().isVisible()).toBe(false);
    await page.locator('#hatch').check();
    expect(await page.locator('.sheet .hatch').first().isVisible()).toBe(true);
    await studio.drawn('#model-picture');
    await studio.picture('hatched');
    expect(studio.complaints).toEqual([]);
  }));

test('a model is turned and brought nearer by keys and by the mouse', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await studio.chooseSample('House');
    await studio.resultOf('house');
    const canvas = page.locator('#model-picture');
    await studio.drawn('#model-picture');
    const changes = async (action: () => Promise<unknown>): Promise<void> => {
      const before = await canvas.screenshot();
      await action();
      await expect.poll(async () => before.equals(await canvas.screenshot())).toBe(false);
    };
    await canvas.focus();
    for (const key of ['ArrowRight', 'ArrowUp', '+']) await changes(() => page.keyboard.press(key));
    await canvas.hover();
    await changes(() => page.mouse.wheel(0, 200));
    await page.mouse.down();
    await changes(() => page.mouse.move(600, 300));
    await page.mouse.up();
    expect(studio.complaints).toEqual([]);
  }));
