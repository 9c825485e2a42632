/** A run can be watched, and ended at any time, and leaves a page that works. */
import { expect, test } from 'vitest';
import { cancelAt, stageWords } from './page-clock.js';
import { objText, wavyRing } from '../web/model-text.js';
import { box } from '../web/solids.js';
import { untilKept } from './kept-work.js';
import { useStudio } from './studio-fixture.js';
import type { StudioPage } from './studio-page.js';

const withStudio = useStudio();

/** Starts a run that takes minutes, so that it can be watched on any machine. */
async function beginLongRun(studio: StudioPage): Promise<void> {
  await studio.page.fill('#parts', '2');
  await studio.page.selectOption('#solver', 'genetic');
  await studio.choose('ring.obj', objText(wavyRing(24)));
}

/** Two boxes, which are laid flat at once, and a ring that takes minutes. */
function ringAndBoxes(): string {
  const ring = wavyRing(24);
  const solids = [box(30, 30, 30), box(20, 30, 45)].map(({ positions, corners }, i) => {
    const moved = positions.map((value, at) => value + (at % 3 === 0 ? 100 + 80 * i : 0));
    return { moved, corners };
  });
  const { vertices, faces } = ring;
  for (const { moved, corners } of solids) {
    const first = vertices.length;
    for (let at = 0; at < moved.length; at += 3) vertices.push(moved.slice(at, at + 3));
    for (let at = 0; at < corners.length; at += 3) {
      faces.push(corners.slice(at, at + 3).map((corner) => first + corner));
    }
  }
  return objText(ring);
}

async function beginRingAndBoxes(studio: StudioPage): Promise<void> {
  await studio.page.fill('#parts', '3');
  await studio.page.selectOption('#solver', 'genetic');
  await studio.choose('boxes.obj', ringAndBoxes());
}

/** What an element has said so far, each thing once, in its order. */
async function listenTo({ page }: StudioPage, selector: string): Promise<() => Promise<string[]>> {
  const heard = await page.evaluateHandle((name) => {
    const { shadowRoot } = document.querySelector('foldwright-studio')!;
    const element = shadowRoot!.querySelector(name)!;
    const words: string[] = [];
    const note = (): void => {
      const text = element.textContent ?? '';
      if (words.at(-1) !== text) words.push(text);
    };
    new MutationObserver(note).observe(element, {
      childList: true,
      characterData: true,
      subtree: true,
    });
    return words;
  }, selector);
  return () => heard.jsonValue();
}

test('model, foldability, net and fitness are drawn while a run goes on', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await beginLongRun(studio);
    const how = page.locator('#how');
    await how.waitFor();
    expect(await how.getAttribute('open')).toBeNull();
    expect(await page.locator('#matrix').isVisible()).toBe(false);
    await page.getByText('How it works').click();
    await page.locator('#net-words', { hasText: 'generation' }).waitFor({ timeout: 60_000 });
    await page.locator('#chart .curve--now').waitFor();
    const words = await page.locator('#net-words').innerText();
    // Generations go on while one looks.
    await page.locator('#net-words', { hasNotText: words }).waitFor();
    for (const canvas of ['#model-picture', '#matrix', '#chart', '#net'])
      await studio.drawn(canvas);
    await page.locator('#cancel').click();
    await page.locator('#announcement', { hasText: 'Cancelled.' }).waitFor();
    await studio.drawn('#model-picture');
    // Whoever wants to know how it works wants that of the next run, too.
    await beginLongRun(studio);
    await page.locator('#net-words', { hasText: 'generation' }).waitFor({ timeout: 60_000 });
    await page.locator('#cancel').click();
    expect(studio.complaints).toEqual([]);
  }));

test('nets come together as they are found, and what is left never grows', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    const [progress, nets] = [
      await listenTo(studio, '#progress-words'),
      await listenTo(studio, '#nets-words'),
    ];
    await beginRingAndBoxes(studio);
    await page.locator('#nets-words', { hasText: '2 nets found so far' }).waitFor();
    await studio.drawn('#nets');
    // Until all parts are searched, the number of overlaps would grow with each of them.
    await page.locator('#progress-words', { hasText: '2 of 3 parts done' }).waitFor();
    await page.locator('#progress-words', { hasText: 'left' }).waitFor();
    await expect
      .poll(async () => (await progress()).filter((words) => words.includes('left')).length, {
        timeout: 20_000,
      })
      .toBeGreaterThan(2);
    await page.locator('#cancel').click();
    await page.locator('#announcement', { hasText: 'Cancelled.' }).waitFor();
    const told = await progress();
    const numbers = (pattern: RegExp): number[] =>
      told.flatMap((words) => pattern.exec(words)?.slice(1).map(Number) ?? []);
    const overlaps = numbers(/(\d+) overlaps? left/);
    expect(overlaps).toEqual([...overlaps].sort((a, b) => b - a));
    const done = numbers(/(\d+) of 3 parts done/);
    expect(done).toEqual([...done].sort((a, b) => a - b));
    expect((await nets()).filter((words) => words.includes('found')).length).toBeGreaterThan(0);
    expect(studio.complaints).toEqual([]);
  }));

test('sheets that could be printed are shown before nets are as good as they get', () =>
  withStudio(async (studio) => {
    const words = await listenTo(studio, '#nets-words');
    await studio.page.fill('#parts', '8');
    await studio.choose('ring.obj', objText(wavyRing(20)));
    await studio.page.locator('#nets-words', { hasText: 'could be printed now' }).waitFor();
    await studio.drawn('#nets');
    await studio.resultOf('ring');
    const told = await words();
    const first = told.findIndex((text) => text.includes('could be printed now'));
    expect(told.slice(first).filter((text) => text.includes('found so far'))).toEqual([]);
    expect(studio.complaints).toEqual([]);
  }));

test('a run that is stopped gives the pieces that it has found, to be printed and changed', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await beginRingAndBoxes(studio);
    await page.locator('#nets-words', { hasText: '2 nets found so far' }).waitFor();
    await page.getByRole('button', { name: 'Stop and use this' }).click();
    const hash = await studio.resultOf('boxes');
    expect(hash).not.toBe('');
    const lead = await page.locator('#result-lead').innerText();
    expect(lead).toMatch(
      /^Only 2 of 3 parts are whole: 2 pieces on \d+ sheets? of A4\. The other part is missing/,
    );
    expect(await page.locator('#announcement').textContent()).toBe(`Stopped. ${lead}`);
    expect(await page.locator('#stop').isVisible()).toBe(false);
    const { name, bytes } = await studio.download('FOLD');
    const { file_frames: frames } = JSON.parse(bytes.toString()) as { file_frames: unknown[] };
    expect([name, frames.length > 0]).toEqual(['boxes.fold', true]);
    expect((await studio.download('PDF')).bytes.subarray(0, 5).toString()).toBe('%PDF-');
    // It is a document like any other; its edits go on to look for what is missing, until they are stopped, too.
    await page.locator('.part').last().click();
    await page.locator('#split').click();
    await page.locator('#progress-words', { hasText: '3 of 4 parts done' }).waitFor();
    await page.getByRole('button', { name: 'Stop and use this' }).click();
    await page.locator('#announcement', { hasText: 'Done: Only 3 of 4 parts' }).waitFor();
    await page.locator('#undo').click();
    await page.locator('#announcement', { hasText: 'Undone:' }).waitFor();
    expect(await page.locator('#result').getAttribute('data-hash')).toBe(hash);
    expect(studio.complaints).toEqual([]);
  }));

test('a run that was stopped is kept as what it is, and can be let finish', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    const row = page.locator('#verdict-rows [data-code="run-stopped"]');
    await page.fill('#parts', '8');
    await studio.choose('ring.obj', objText(wavyRing(20)));
    await page.locator('#nets-words', { hasText: 'could be printed now' }).waitFor();
    await page.getByRole('button', { name: 'Stop and use this' }).click();
    const hash = await studio.resultOf('ring');
    await row.waitFor();
    await untilKept(page, ([first]) => first?.hashes[0] === hash);
    await page.reload();
    await page.getByRole('button', { name: 'Go on with “ring”' }).click();
    expect(await studio.resultOf('ring')).toBe(hash);
    expect(await page.locator('#announcement').textContent()).toContain('Stopped. ');
    expect(await row.innerText()).toContain('The search was stopped before its end');
    await row.getByRole('button', { name: 'Unfold again to the end' }).click();
    await page.locator(`#result:not([data-hash="${hash}"])`).waitFor();
    await studio.resultOf('ring');
    expect(await page.locator('#verdict-rows').innerText()).not.toContain('stopped');
    expect(studio.complaints).toEqual([]);
  }));

test('a run that is cancelled keeps nothing, however many nets it has', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await studio.chooseSample('Cube');
    const hash = await studio.resultOf('cube');
    await beginRingAndBoxes(studio);
    await page.locator('#stop').waitFor();
    await page.locator('#cancel').click();
    await page.locator('#progress').waitFor({ state: 'hidden' });
    expect(await page.locator('#result').getAttribute('data-hash')).toBe(hash);
    expect(await page.locator('#announcement').textContent()).toBe('Cancelled.');
    // Nobody has asked for its nets: it is over at once, and so is one without a result before it.
    await page.reload();
    await page.locator('.sample').first().waitFor();
    await studio.unfoldSettings();
    await beginRingAndBoxes(studio);
    await page.locator('#stop').waitFor();
    await page.locator('#cancel').click();
    await page.locator('#progress').waitFor({ state: 'hidden' });
    expect(await page.locator('#result').isVisible()).toBe(false);
    expect(await page.locator('#workshop-note').innerText()).toContain('nothing of it is kept');
    expect(studio.complaints).toEqual([]);
  }));

test('a run can be ended in every stage, and the next one works', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    for (const stage of stageWords) {
      const answered = cancelAt(studio, stage);
      await studio.chooseSample('Duck');
      await answered;
      expect(await page.locator('#announcement').textContent()).toBe('Cancelled.');
      expect(await page.locator('#progress').isVisible()).toBe(false);
      expect(await page.locator('#message').isVisible()).toBe(false);
      await studio.chooseSample('Cube');
      await studio.resultOf('cube');
      await studio.drawn('#model-picture');
    }
    expect(studio.complaints).toEqual([]);
  }));

test('the last result comes back when the run after it is cancelled', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await studio.chooseSample('Cube');
    await studio.resultOf('cube');
    await beginLongRun(studio);
    await page.locator('#workshop').waitFor();
    expect(await page.locator('#result').isVisible()).toBe(false);
    await page.locator('#cancel').click();
    await page.locator('#result').waitFor();
    expect((await studio.download('FOLD')).name).toBe('cube.fold');
    expect(studio.complaints).toEqual([]);
  }));
