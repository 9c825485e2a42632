/** The code examples of all pages, from the Markdown that the pages are made of. */
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import MarkdownIt from 'markdown-it';
import { repositoryPages } from '../../site/repository-pages.mjs';
import { root } from '../web/packed.js';

export interface Example {
  /** Path of the file that it is in, and its line, counted from 1. */
  source: string;
  line: number;
  /** As it stands behind the fence; '' for what is no code. */
  language: string;
  code: string;
}

const ownPages = readdirSync(join(root, 'site/pages'))
  .filter((name) => name.endsWith('.md'))
  .map((name) => `site/pages/${name}`);

/** Files of Markdown that are pages of the site; those of the API have no examples. */
export const sources = [...Object.keys(repositoryPages), ...ownPages];

function examplesIn(source: string): Example[] {
  const text = readFileSync(join(root, source), 'utf8');
  const tokens = new MarkdownIt({ html: true }).parse(text, {});
  return tokens
    .filter(({ type }) => type === 'fence')
    .map(({ info, content, map }) => ({
      source,
      line: map![0] + 1,
      language: info.trim().split(' ')[0]!,
      code: content,
    }));
}

export const examples = sources.flatMap(examplesIn);

/**
 * Examples with hosts and hashes that each reader has others of: they run nowhere as they stand. Frames and hashes
 * have tests of their own in `tests/e2e` and `tests/web`.
 */
export const sketches = examples.filter(({ code }) => /\bpaper\.example\b|…/.test(code));

/** Those in one of some languages, with a name for reports. */
export function examplesOf(...languages: string[]): (Example & { name: string })[] {
  return examples
    .filter((example) => languages.includes(example.language) && !sketches.includes(example))
    .map((example) => ({ ...example, name: `${example.source}:${example.line}` }));
}
