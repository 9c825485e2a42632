// Markdown as GitHub reads it, so that the same files are documents of the repository and pages of the site.
import MarkdownIt from 'markdown-it';
import { resolvedLink } from './addresses.mjs';

/** The name of a heading in addresses, as GitHub makes it. */
export function slugOf(text) {
  return text
    .trim()
    .toLowerCase()
    .replace(/[^\p{L}\p{N}\s_-]/gu, '')
    .replace(/\s/g, '-');
}

const textOf = ({ children }) =>
  children
    .filter(({ type }) => type === 'text' || type === 'code_inline')
    .map(({ content }) => content)
    .join('');

/** Gives each heading its name; of equal ones the later ones get a number. */
function nameHeadings({ tokens }) {
  const counts = new Map();
  tokens.forEach((token, i) => {
    if (token.type !== 'heading_open') return;
    const slug = slugOf(textOf(tokens[i + 1]));
    const count = counts.get(slug) ?? 0;
    counts.set(slug, count + 1);
    token.attrSet('id', count === 0 ? slug : `${slug}-${count}`);
  });
}

/** The file that is rendered; pages of the repository name theirs. */
const sourceOf = ({ source, page }) => source ?? page.inputPath.replace(/^\.\//, '');

/** Leads links and pictures from file to file to the pages that are made of these files. */
function resolveLinks({ tokens, env }) {
  const inline = tokens.flatMap(({ children }) => children ?? []);
  for (const token of inline) {
    const name = token.type === 'image' ? 'src' : 'href';
    const link = token.attrGet(name);
    if (link !== null) token.attrSet(name, resolvedLink(sourceOf(env), link));
  }
}

/** Wide tables scroll by themselves, which the keyboard can do as well. */
function wrapTables(markdown) {
  const { rules } = markdown.renderer;
  rules.table_open = () =>
    '<div class="table" tabindex="0" role="group" aria-label="Table"><table>\n';
  rules.table_close = () => '</table></div>\n';
}

/** A heading without words is none: the cell above a column that explains itself is a plain one. */
function emptyHeadings({ tokens }) {
  tokens.forEach((token, i) => {
    if (token.type !== 'th_open' || tokens[i + 1].content !== '') return;
    token.tag = 'td';
    tokens[i + 2].tag = 'td';
  });
}

/** Code scrolls by itself, too. */
function keyboardCode(markdown) {
  const { rules } = markdown.renderer;
  const usual = rules.fence;
  rules.fence = (...args) => usual(...args).replace('<pre>', '<pre tabindex="0">');
}

/** @returns {MarkdownIt} what renders with the data of an Eleventy page as its environment */
export function markdownLibrary() {
  const markdown = new MarkdownIt({ html: true });
  markdown.core.ruler.push('name-headings', nameHeadings);
  markdown.core.ruler.push('resolve-links', resolveLinks);
  markdown.core.ruler.push('empty-headings', emptyHeadings);
  wrapTables(markdown);
  keyboardCode(markdown);
  return markdown;
}
