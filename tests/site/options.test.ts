/** The page of options has all of them, each with pictures or with the reason why there is none. */
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { rows } from '../../web/model/options.js';
import { optionHelp } from '../../web/words/en/option-help.js';
import { attributes, pages, site } from './built-pages.js';

const html = pages.get('options.html')!;

/** What stands below the heading of an option, up to the next heading. */
function sectionOf(name: string): string {
  const [, rest] = html.split(`<h3 id="option-${name}">`) as [string, string?];
  return rest?.split(/<h[23]\b/)[0] ?? '';
}

describe('the page of options', () => {
  it.each(Object.keys(rows) as (keyof typeof rows)[])('tells of --%s and shows it', (name) => {
    const section = sectionOf(name);
    const { fallback } = rows[name];
    expect(section).toContain(`<code>${fallback}</code>`);
    expect(section).toContain(optionHelp[name].slice(1, 20).replaceAll('&', '&amp;'));
    const pictures = attributes(section, 'src', 'img');
    if (pictures.length === 0) expect(section).toContain('No picture.');
    else expect(pictures.length).toBeGreaterThan(1);
    for (const picture of pictures) expect(existsSync(join(site, picture))).toBe(true);
  });

  it('shows a difference between most values', () => {
    const same = Object.keys(rows).filter((name) => {
      const pictures = attributes(sectionOf(name), 'src', 'img');
      return (
        new Set(pictures.map((path) => readFileSync(join(site, path), 'utf8'))).size <
        pictures.length
      );
    });
    expect(same).toEqual([]);
  });
});
