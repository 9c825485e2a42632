// The list of what is on a long page, from its headings of the second level.

/** So many headings fit on a screen without a list of them. */
const fewHeadings = 3;

const linkTo = ([, id, text]) => `<li><a href="#${id}">${text.replace(/<[^>]+>/g, '')}</a></li>`;

/** Puts a list of a long page's headings below its title. */
export function withOutline(html) {
  const headings = [...html.matchAll(/<h2 id="([^"]+)"[^>]*>(.*?)<\/h2>/gs)];
  if (headings.length <= fewHeadings) return html;
  const list = `<ul>${headings.map(linkTo).join('')}</ul>`;
  const outline = `<details class="outline"><summary>On this page</summary>${list}</details>`;
  return html.replace('</h1>', () => `</h1>\n${outline}`);
}
