import type { Page } from 'playwright-core';

/** The name of the root element of an XML text by the browser's own parser; `parsererror` if bad. */
export function wellFormed(page: Page, text: string): Promise<string> {
  return page.evaluate((source) => {
    const parsed = new DOMParser().parseFromString(source, 'image/svg+xml');
    return parsed.querySelector('parsererror')?.tagName ?? parsed.documentElement.tagName;
  }, text);
}
