import type { Page } from 'playwright-core';

interface Watched {
  shifts: string[];
}

/** From now on notes whatever moves on the page by itself: not within half a second of what a person does. */
export async function watchShifts(page: Page): Promise<void> {
  await page.evaluate(() => {
    const shifts: string[] = [];
    (window as unknown as Watched).shifts = shifts;
    const observer = new PerformanceObserver((list) => {
      for (const entry of list.getEntries()) {
        const { value, hadRecentInput, sources } = entry as PerformanceEntry & {
          value: number;
          hadRecentInput: boolean;
          sources: { previousRect: DOMRectReadOnly; currentRect: DOMRectReadOnly }[];
        };
        if (hadRecentInput) continue;
        const rect = ({ x, y, width, height }: DOMRectReadOnly): string =>
          [x, y, width, height].map(Math.round).join(' ');
        const moved = sources.map((one) => `${rect(one.previousRect)} to ${rect(one.currentRect)}`);
        shifts.push(`${value.toFixed(4)}: ${moved.join(', ')}`);
      }
    });
    observer.observe({ type: 'layout-shift' });
  });
}

/** What has moved since then; nothing, if all is well. */
export async function shiftsOf(page: Page): Promise<string[]> {
  // They are told after the frame.
  await page.waitForTimeout(300);
  return page.evaluate(() => (window as unknown as Watched).shifts);
}
