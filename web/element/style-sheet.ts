/**
 * What makes a style sheet for the shadow roots of all elements of a kind: once, with the first of them. Unlike a style
 * element it is no matter of a page's content security policy.
 */
export function sharedStyleSheet(styles: string): () => CSSStyleSheet {
  let sheet: CSSStyleSheet | null = null;
  return () => {
    if (sheet) return sheet;
    sheet = new CSSStyleSheet();
    sheet.replaceSync(styles);
    return sheet;
  };
}
