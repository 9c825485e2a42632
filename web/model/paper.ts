/** A named sheet of paper, portrait, in mm. */
export interface PaperSize {
  name: string;
  width: number;
  height: number;
}

/** The papers that people can buy for home and office printers and for cutting machines. */
export const paperSizes: readonly PaperSize[] = [
  { name: 'A2', width: 420, height: 594 },
  { name: 'A3', width: 297, height: 420 },
  { name: 'A4', width: 210, height: 297 },
  { name: 'A5', width: 148, height: 210 },
  { name: 'Letter', width: 215.9, height: 279.4 },
  { name: 'Legal', width: 215.9, height: 355.6 },
  { name: 'Tabloid', width: 279.4, height: 431.8 },
  { name: '12x12in', width: 304.8, height: 304.8 },
];

/** Sides of a sheet in mm. Below, no sheet has room beside a margin; above, no printer or cutter takes it. */
export const [leastSide, mostSide] = [20, 5000] as const;

/** The paper with this name, in upper or lower case, or of WxH mm, which comes back portrait; null if it is neither. */
export function paperCalled(text: string): PaperSize | null {
  const named = paperSizes.find(({ name }) => name.toLowerCase() === text.toLowerCase());
  if (named) return named;
  const sides = /^(\d+(?:\.\d+)?)x(\d+(?:\.\d+)?)$/.exec(text)?.slice(1).map(Number);
  if (!sides?.every((side) => side >= leastSide && side <= mostSide)) return null;
  return { name: text, width: Math.min(...sides), height: Math.max(...sides) };
}
