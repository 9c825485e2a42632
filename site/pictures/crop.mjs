// A window of a sheet as an SVG of its own. Sheets are in mm, with y down in SVG and up in results.

/** Around pieces, so that their outlines do not touch the frame. */
const margin = 5;

/** The box of all pieces of the first sheet. */
function boxOfPieces({ pieces, sheets }) {
  const first = pieces.filter(({ sheet }) => sheet === 0);
  const left = Math.min(...first.map(({ x }) => x)) - margin;
  const right = Math.max(...first.map(({ x, width }) => x + width)) + margin;
  const low = Math.min(...first.map(({ y }) => y)) - margin;
  const high = Math.max(...first.map(({ y, height }) => y + height)) + margin;
  return [left, sheets[0].height - high, right - left, high - low];
}

/** A window of so many mm about a place of a piece, which is given as shares of its box from the left and below. */
function aboutPlace({ pieces, sheets }, { piece = 0, at: [across, up], size: [width, height] }) {
  const { x, y, ...own } = pieces[piece];
  const middle = [x + across * own.width, sheets[0].height - y - up * own.height];
  return [middle[0] - width / 2, middle[1] - height / 2, width, height];
}

/** Windows of a sheet of this size that do not depend on pieces. */
const places = {
  sheet: ({ width, height }) => [0, 0, width, height],
  ruler: ({ height }) => [0, height - 62, 84, 62],
  head: () => [0, 0, 120, 90],
  foot: ({ width, height }) => [width - 150, height - 62, 150, 62],
};

/**
 * @param result of the run
 * @param shown the name of a place, `pieces` for all of them, or a place of a piece
 * @returns {number[]} left, top, width and height
 */
export function windowOf(result, shown) {
  const [sheet] = result.sheets;
  if (shown === 'pieces') return boxOfPieces(result);
  return typeof shown === 'string' ? places[shown](sheet) : aboutPlace(result, shown);
}

/** Pixels to a millimetre, and how wide a picture is at least: what is seen from near shall be large. */
const [usualZoom, leastPixels] = [4, 352];

const short = (value) => Number(value.toFixed(2));

/** A window of a sheet that was written as SVG, on white paper. */
export function cropped(svg, [left, top, width, height]) {
  const box = [left, top, width, height].map(short).join(' ');
  const [w, h] = [short(width), short(height)];
  const zoom = Math.max(usualZoom, leastPixels / width);
  const opened = svg.replace(/ width="[^"]*" height="[^"]*" viewBox="[^"]*"/, '');
  return opened
    .replace(
      '<svg ',
      `<svg width="${short(zoom * w)}" height="${short(zoom * h)}" viewBox="${box}" `,
    )
    .replace(
      /(<svg [^>]*>)/,
      `$1<rect x="${left}" y="${top}" width="${w}" height="${h}" fill="#fff"/>`,
    );
}
