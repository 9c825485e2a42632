import { afterAll, beforeAll } from 'vitest';
import type { Engine } from './engine-page.js';
import { chromium, firefox } from './puppets.js';
import { openScreen, type VirtualScreen } from './virtual-screen.js';
import { serveWatched, type WatchedSite } from './watched-site.js';
import { WatchedStudio } from './watched-studio.js';
import { webkit } from './webkit.js';

export const engines: readonly Engine[] = [chromium, firefox, webkit];

/**
 * Serves a page with a studio and opens a screen for the tests of one file. What it returns opens the studio in an engine,
 * hands it to `work` and closes it whatever happens.
 *
 * @param serveSite of a page that is watched by `watchPage`; by default the studio's own
 */
export function useEngines(
  serveSite: () => Promise<WatchedSite> = serveWatched,
): (engine: Engine, work: (studio: WatchedStudio) => Promise<void>) => Promise<void> {
  let [site, screen]: [WatchedSite | null, VirtualScreen | null] = [null, null];
  beforeAll(async () => {
    screen = await openScreen();
    site = await serveSite();
  });
  afterAll(async () => {
    await site?.close();
    screen?.close();
  });
  return async (engine, work) => {
    if (!site || !screen) throw new Error('The studio is not served');
    const studio = await WatchedStudio.open(engine, screen.display, site.address);
    try {
      await work(studio);
    } finally {
      await studio.close();
    }
  };
}
