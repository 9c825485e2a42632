import type { Page } from 'playwright-core';

/**
 * A point of the window inside a piece on a sheet where no edge is near, with the mouse on it: the middle of its box
 * may lie outside. On whole pixels, as clicks are.
 *
 * @param selector of the piece
 */
export async function pointInside(page: Page, selector: string): Promise<[x: number, y: number]> {
  const piece = page.locator(selector).first();
  await piece.evaluate((path) => path.scrollIntoView({ block: 'center' }));
  const places = await piece.evaluate((path: SVGPathElement) => {
    const { x: left, y: top, width, height } = path.getBBox();
    const shares = Array.from({ length: 30 }, (_, i) => (i + 0.5) / 30);
    const points = shares.flatMap((u) =>
      shares.map((v) => new DOMPoint(left + u * width, top + v * height)),
    );
    const screen = path.getScreenCTM()!;
    const back = screen.inverse();
    // What is scrolled out of sight lies behind something else: the model there would light the piece as well.
    const isSeen = ({ x, y }: DOMPoint): boolean => {
      const top = (path.getRootNode() as ShadowRoot).elementFromPoint(x, y);
      return top?.closest('svg') === path.ownerSVGElement;
    };
    return points
      .map((point) => point.matrixTransform(screen))
      .map(({ x, y }) => new DOMPoint(Math.round(x), Math.round(y)))
      .filter((point) => path.isPointInFill(point.matrixTransform(back)) && isSeen(point))
      .map(({ x, y }) => [x, y] as [x: number, y: number]);
  });
  for (const [x, y] of places) {
    await page.mouse.move(x, y);
    const isOnEdge = (await page.locator('#edge-line').textContent()) !== '';
    if (!isOnEdge && (await page.locator('#piece-line').textContent()) !== '') return [x, y];
  }
  throw new Error('Edges are everywhere near');
}
