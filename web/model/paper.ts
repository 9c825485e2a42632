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
