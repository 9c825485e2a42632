// The documentation site: `npm run site` calls Eleventy with this file, after the pictures and the API's pages were made.
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { addressOf, apiFolder, withRelativeAddresses } from './addresses.mjs';
import { markdownLibrary } from './markdown.mjs';
import { navigation } from './navigation.mjs';
import { withOutline } from './outline.mjs';
import { copiedFiles, repositoryPages, titles } from './repository-pages.mjs';

/** The first heading of a Markdown file, without marks of code. */
const headingOf = (text) => /^# (.+)$/m.exec(text)?.[1].replaceAll(/[`\\]/g, '') ?? '';

/** Makes a page of a Markdown file that lies outside of the site's own folder, without looking for templates in it. */
function addPage(config, path) {
  const text = readFileSync(path, 'utf8');
  config.addTemplate(`from/${path}`, text, {
    layout: 'page.njk',
    title: titles[path] ?? headingOf(text),
    permalink: addressOf(path),
    source: path,
    templateEngineOverride: 'md',
  });
}

/** Pages of the API, which are not there when only the texts are looked at. */
function apiPages() {
  if (!existsSync(apiFolder)) return [];
  return readdirSync(apiFolder, { recursive: true })
    .filter((name) => name.endsWith('.md'))
    .map((name) => join(apiFolder, name));
}

function addFiles(config) {
  for (const [path, address] of Object.entries(copiedFiles)) {
    config.addPassthroughCopy({ [path]: address });
  }
  config.addPassthroughCopy({
    'site/style.css': '/style.css',
    'site/drawings': '/drawings',
    'web/app/styles/tokens.css': '/tokens.css',
    'web/app/public/icon.svg': '/icon.svg',
    'build/site/pictures': '/pictures',
    'build/site/models': '/models',
    'build/site/demos': '/demos',
    'dist/studio': '/studio',
  });
}

/** A page's address with the name of its file, which Eleventy leaves out where servers know it. */
const fileAddress = (url) => (url.endsWith('/') ? `${url}index.html` : url);

/** The groups of pages with their titles, for the list of all pages. */
function menuOf(pages, current) {
  const byAddress = new Map(pages.map(({ url, data }) => [fileAddress(url), data.title]));
  return navigation.map(({ title, pages: addresses }) => ({
    title,
    pages: addresses
      .filter((address) => byAddress.has(address))
      .map((address) => ({
        address,
        title: byAddress.get(address),
        isCurrent: address === fileAddress(current),
      })),
  }));
}

export default function configure(config) {
  config.setLibrary('md', markdownLibrary());
  config.addFilter('menu', menuOf);
  config.addFilter('outlined', withOutline);
  config.addTransform('relative-addresses', function relative(html) {
    return this.page.outputPath?.endsWith('.html')
      ? withRelativeAddresses(html, fileAddress(this.page.url))
      : html;
  });
  for (const path of [...Object.keys(repositoryPages), ...apiPages()]) addPage(config, path);
  addFiles(config);
  return {
    dir: { input: 'site/pages', layouts: '../layouts', data: '../data', output: 'dist/site' },
    markdownTemplateEngine: 'njk',
  };
}
