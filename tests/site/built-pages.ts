/** The pages of the built site as files. */
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { root } from '../web/packed.js';

export const site = join(root, 'dist/site');

/** `npm run test:site` builds it first. */
if (!existsSync(site)) throw new Error('There is no site: npm run site builds it');

/** The studio has pages of its own, with tests of their own. */
const isOwn = (path: string): boolean => path.endsWith('.html') && !path.startsWith('studio/');

export const paths = readdirSync(site, { recursive: true, encoding: 'utf8' }).filter(isOwn).sort();

export const pages = new Map(
  paths.map((path) => [path, readFileSync(join(site, path), 'utf8')] as const),
);

/** Values of an attribute in a page, of tags whose names fit. */
export function attributes(html: string, name: string, tags = '[\\w-]+'): string[] {
  const pattern = new RegExp(`<(?:${tags})\\b[^>]*?\\s${name}="([^"]*)"`, 'g');
  return [...html.matchAll(pattern)].map(([, value]) => value!.replaceAll('&amp;', '&'));
}
