import { fileURLToPath } from 'node:url';
import { afterAll, beforeAll } from 'vitest';
import { serve } from '../../scripts/serve.mjs';
import { sharedBrowser } from './shared-browser.js';
import { StudioPage, type BrowserOptions } from './studio-page.js';

// The folder above the studio is served, so that an address that is not relative leads nowhere.
const built = fileURLToPath(new URL('../../dist', import.meta.url));

/**
 * Serves the built studio for the tests of one file. What it returns opens the page, hands it to
 * `work` and closes it whatever happens.
 */
export function useStudio(): (
  work: (studio: StudioPage) => Promise<void>,
  options?: BrowserOptions,
) => Promise<void> {
  let server: Awaited<ReturnType<typeof serve>> | null = null;
  beforeAll(async () => {
    server = await serve(built);
  });
  afterAll(() => server?.close());
  return async (work, options) => {
    if (!server) throw new Error('The studio is not served');
    const browser = options?.flags ? undefined : await sharedBrowser();
    const studio = await StudioPage.open(`${server.address}studio/`, options, browser);
    try {
      await work(studio);
    } finally {
      await studio.close();
    }
  };
}
