import type { PrintedPage } from '../export/printed-pages.js';
import { make } from './dom.js';

type Paper = Pick<PrintedPage, 'width' | 'height'>;

/** Names a size of paper, for the style. */
function paperName({ width, height }: Paper): string {
  return `paper-${width}x${height}`.replaceAll('.', '_');
}

/**
 * The style of a document whose pages have the size of their sheets, without margins, so that a browser prints them
 * at true size: each page is one element of the class `page`.
 */
export function paperRules(pages: readonly Paper[]): string {
  const papers = new Map(pages.map((page) => [paperName(page), page]));
  const sizes = [...papers].map(
    ([name, { width, height }]) =>
      `@page ${name} { size: ${width}mm ${height}mm; margin: 0 }\n` +
      // A little less high than the paper: rounded up, it would begin another page. Nothing is cut off or made smaller.
      `.${name} { page: ${name}; width: ${width}mm; height: calc(${height}mm - 0.5px) }\n` +
      `.${name} img { width: ${width}mm; height: ${height}mm }`,
  );
  const [first] = pages;
  return [
    // For browsers that know no names of pages.
    first ? `@page { size: ${first.width}mm ${first.height}mm; margin: 0 }` : '',
    'html, body { margin: 0; padding: 0; background: none }',
    '.page { position: relative; overflow: visible; break-after: page; break-inside: avoid }',
    '.page:last-child { break-after: auto }',
    '.page img { position: absolute; top: 0; left: 0 }',
    ...sizes,
  ].join('\n');
}

/** The address of a picture. Every policy that lets a studio in allows it, other than one of a blob. */
export function pictureAddress({ svg }: Pick<PrintedPage, 'svg'>): string {
  return `data:image/svg+xml;charset=utf-8,${encodeURIComponent(svg)}`;
}

async function fill(page: Document, pages: readonly PrintedPage[]): Promise<void> {
  const view = page.defaultView;
  if (!view) throw new Error('A document that is not on the page cannot be printed');
  // Unlike a style element it is no matter of a content security policy.
  const style = new view.CSSStyleSheet();
  style.replaceSync(paperRules(pages));
  page.adoptedStyleSheets = [style];
  const pictures = pages.map((one) => {
    const box = page.createElement('div');
    box.className = `page ${paperName(one)}`;
    const picture = page.createElement('img');
    picture.src = pictureAddress(one);
    picture.alt = '';
    box.append(picture);
    page.body.append(box);
    return picture;
  });
  await Promise.all(pictures.map((picture) => picture.decode()));
}

/**
 * Prints pages, and nothing else, by the browser's own dialogue; a document of their own, which has a title, lies in
 * `host` meanwhile.
 */
export async function printPages(
  host: ParentNode,
  pages: readonly PrintedPage[],
  title: string,
): Promise<void> {
  const frame = make('iframe', { className: 'print-frame', tabIndex: -1 });
  frame.setAttribute('aria-hidden', 'true');
  frame.title = title;
  host.append(frame);
  const { contentDocument, contentWindow } = frame;
  if (!contentDocument || !contentWindow) throw new Error('This page takes no frame');
  await fill(contentDocument, pages);
  // Some browsers come back at once, and read the document later.
  contentWindow.addEventListener('afterprint', () => setTimeout(() => frame.remove()));
  contentWindow.focus();
  contentWindow.print();
}
