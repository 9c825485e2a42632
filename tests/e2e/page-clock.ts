import { stages } from '../../web/model/stages.js';
import { english } from '../../web/words/en/index.js';
import type { StudioPage } from './studio-page.js';

/** Words with which the progress of a stage begins, in the order of the stages. */
export const stageWords = stages.map((stage) => english.run.stages[stage]);

/**
 * Cancels the next run as soon as the words of a stage appear. Resolves, once such a run has been
 * started and has ended, with the ms from the click until the page said that it was over.
 */
export function cancelAt({ page }: StudioPage, words: string): Promise<number> {
  return page.evaluate((start) => {
    const { shadowRoot } = document.querySelector('foldwright-studio')!;
    const stage = shadowRoot!.querySelector('#progress-words')!;
    const card = shadowRoot!.querySelector<HTMLElement>('#progress')!;
    const all = { childList: true, characterData: true, subtree: true, attributes: true };
    return new Promise<number>((resolve) => {
      const began = new MutationObserver(() => {
        if (!stage.textContent?.startsWith(start)) return;
        began.disconnect();
        const before = performance.now();
        const ended = new MutationObserver(() => {
          if (card.hidden) resolve(performance.now() - before);
        });
        ended.observe(card, all);
        shadowRoot!.querySelector<HTMLElement>('#cancel')!.click();
      });
      began.observe(stage, all);
    });
  }, words);
}

/** What a run was like for the page's own thread; all in ms. */
export interface RunTimes {
  /** From the drop of the file until its nets were on the page. */
  nets: number;
  /** Lengths of the tasks over 50 ms, until a second later. */
  longTasks: number[];
}

/** Drops a model and follows the run to its nets. */
export function timeRun({ page }: StudioPage, name: string, content: string): Promise<RunTimes> {
  return page.evaluate(
    async ([fileName, text]) => {
      const rest = (ms: number): Promise<void> => new Promise((done) => setTimeout(done, ms));
      const data = new DataTransfer();
      data.items.add(new File([text], fileName));
      // Bringing the text here has made the page busy itself.
      await rest(1000);
      const longTasks: number[] = [];
      const observer = new PerformanceObserver((list) => {
        for (const { duration } of list.getEntries()) longTasks.push(duration);
      });
      observer.observe({ type: 'longtask' });
      const { shadowRoot } = document.querySelector('foldwright-studio')!;
      const result = shadowRoot!.querySelector<HTMLElement>('#result')!;
      const start = performance.now();
      document.body.dispatchEvent(new DragEvent('drop', { dataTransfer: data, bubbles: true }));
      const nets = await new Promise<number>((done) => {
        const shown = new MutationObserver(() => {
          if (!result.hidden) done(performance.now() - start);
        });
        shown.observe(result, { attributes: true });
      });
      await rest(1000);
      observer.disconnect();
      return { nets, longTasks };
    },
    [name, content] as const,
  );
}

/** Plays the folding of a result to its end; the ms between frames of the page meanwhile. */
export function timeFolding({ page }: StudioPage): Promise<number[]> {
  return page.evaluate(() => {
    const frames: number[] = [];
    const { shadowRoot } = document.querySelector('foldwright-studio')!;
    const words = shadowRoot!.querySelector('#folding-words')!;
    shadowRoot!.querySelector<HTMLElement>('#folding-play')!.click();
    return new Promise<number[]>((resolve) => {
      const count = (now: number): void => {
        frames.push(now);
        if (words.textContent !== 'the model') requestAnimationFrame(count);
        else resolve(frames.slice(1).map((frame, i) => frame - frames[i]!));
      };
      requestAnimationFrame(count);
    });
  });
}

/** How often a second the fitness is drawn while a run tells of generation after generation. */
export function drawingsPerSecond(studio: StudioPage): Promise<number> {
  return studio.page.evaluate(async () => {
    let drawings = 0;
    const observer = new MutationObserver(() => ++drawings);
    const { shadowRoot } = document.querySelector('foldwright-studio')!;
    observer.observe(shadowRoot!.querySelector('#chart')!, { childList: true });
    const start = performance.now();
    await new Promise((done) => setTimeout(done, 3000));
    observer.disconnect();
    return (1000 * drawings) / (performance.now() - start);
  });
}
