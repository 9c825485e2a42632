import type { Browser } from 'playwright-core';
import { afterAll } from 'vitest';
import { startChromium } from './chromium.js';

let browser: Promise<Browser> | null = null;

/** The browser of all tests of a file, each of which has a context of its own: a start takes longer than most tests. */
export function sharedBrowser(): Promise<Browser> {
  return (browser ??= startChromium());
}

afterAll(async () => (await browser)?.close());
