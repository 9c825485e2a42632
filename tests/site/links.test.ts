/** Every link of the site leads somewhere, without the network: to a file of the site, and to a place in it. */
import { existsSync } from 'node:fs';
import { join, posix } from 'node:path';
import { describe, expect, it } from 'vitest';
import { navigation } from '../../site/navigation.mjs';
import { attributes, pages, paths, site } from './built-pages.js';

const isForeign = (link: string): boolean => /^[a-z]+:/.test(link);

/** What is wrong with a link of a page; null if nothing is. */
function faultOf(page: string, link: string): string | null {
  if (isForeign(link)) return /^(https|mailto):/.test(link) ? null : 'an address of no known kind';
  if (link.startsWith('/')) return 'not relative';
  const [path, anchor] = link.replace(/\?[^#]*/, '').split('#') as [string, string?];
  const target = path === '' ? page : posix.normalize(posix.join(posix.dirname(page), path));
  if (!existsSync(join(site, target))) return 'no such file';
  const html = pages.get(target);
  if (anchor === undefined || html === undefined) return null;
  const names = [...attributes(html, 'id'), ...attributes(html, 'name', 'a')];
  return names.includes(decodeURIComponent(anchor)) ? null : 'no such place';
}

function faultsOf(page: string): string[] {
  const html = pages.get(page)!;
  const links = [...attributes(html, 'href'), ...attributes(html, 'src')];
  return links.flatMap((link) => {
    const fault = faultOf(page, link);
    return fault === null ? [] : [`${link}: ${fault}`];
  });
}

describe('the site', () => {
  it.each(paths)('has only links in %s that lead somewhere', (page) => {
    expect(faultsOf(page)).toEqual([]);
  });

  it('loads nothing from other hosts', () => {
    const loaded = [...pages].flatMap(([path, html]) =>
      [...attributes(html, 'src'), ...attributes(html, 'href', 'link')]
        .filter(isForeign)
        .map((link) => `${path}: ${link}`),
    );
    expect(loaded).toEqual([]);
  });

  it('offers every page, but for those of the API behind their first one', () => {
    const offered = navigation.flatMap(({ pages: addresses }) => addresses);
    const own = paths.map((path) => `/${path}`).filter((path) => !/^\/api\/.+\//.test(path));
    expect([...offered].sort()).toEqual(own);
  });

  it('says of every picture what it shows', () => {
    const silent = [...pages].flatMap(([path, html]) =>
      [...html.matchAll(/<img\b[^>]*>/g)]
        .map(([tag]) => tag)
        .filter((tag) => !/ alt="/.test(tag))
        .map((tag) => `${path}: ${tag}`),
    );
    expect(silent).toEqual([]);
  });

  it.each(paths)('has one heading of the first level in %s', (page) => {
    expect([...pages.get(page)!.matchAll(/<h1\b/g)]).toHaveLength(1);
  });
});
