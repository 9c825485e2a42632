/** A script for a page that makes its browser one of a person who wants this language. */
export function inLanguage(code: string): string {
  return `Object.defineProperty(navigator, 'languages', { get: () => [${JSON.stringify(code)}] });`;
}
