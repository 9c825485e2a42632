// From links between files of the repository to links between pages of the site.
import { dirname, posix } from 'node:path';
import { copiedFiles, repositoryPages } from './repository-pages.mjs';

/** Where the generated pages of the API lie until they are pages of the site. */
export const apiFolder = 'build/site/api';

/** The address on the site of a file of the repository, from the site's root; null for a file that is not on it. */
export function addressOf(path) {
  const known = repositoryPages[path] ?? copiedFiles[path];
  if (known) return known;
  const own = /^site\/pages\/(.+)\.md$/.exec(path);
  if (own) return `/${own[1]}.html`;
  const api = new RegExp(`^${apiFolder}/(.+)\\.md$`).exec(path);
  return api ? `/api/${api[1]}.html` : null;
}

/** Addresses of other sites, of places in the same page, and those that are written from the site's root. */
const isForeign = (link) => /^(?:[a-z]+:|#|\/)/.test(link);

/**
 * @param {string} source path of the file in which the link stands
 * @param {string} link as it is written there
 * @returns {string} its address from the site's root
 * @throws for a link to a file that is not on the site
 */
export function resolvedLink(source, link) {
  if (isForeign(link)) return link;
  const [path, anchor] = link.split('#');
  const address = addressOf(posix.join(dirname(source), path));
  if (address === null) throw new Error(`${source} links to ${link}, which is not on the site`);
  return anchor === undefined ? address : `${address}#${anchor}`;
}

/** Makes the addresses of a finished page relative, so that the site may lie in any folder of any server. */
export function withRelativeAddresses(html, page) {
  return html.replace(/ (href|src)="(\/[^"]*)"/g, (_, attribute, address) => {
    const [path, anchor] = address.split('#');
    const relative = posix.relative(posix.dirname(page), path);
    return ` ${attribute}="${relative}${anchor === undefined ? '' : `#${anchor}`}"`;
  });
}
