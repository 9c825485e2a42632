import { zlibSync } from 'fflate';
import { PDFName, type PDFDocument, type PDFPage, type PDFRef } from 'pdf-lib';
import type { PaintedPiece } from './texture/paint-piece.js';
import type { PieceImage } from './texture/piece-images.js';
import { packedRows } from './texture/png-file.js';

/** Red, green and blue alone, 3 values per dot. */
function coloursOf(rgba: Uint8Array): Uint8Array {
  const rgb = new Uint8Array((rgba.length / 4) * 3);
  for (let from = 0, to = 0; from < rgba.length; from += 4) {
    rgb[to++] = rgba[from]!;
    rgb[to++] = rgba[from + 1]!;
    rgb[to++] = rgba[from + 2]!;
  }
  return rgb;
}

/** A bit per dot, 1 where nothing is painted; rows begin at whole bytes. */
function maskOf({ rgba, width, height }: PaintedPiece): Uint8Array {
  const stride = Math.ceil(width / 8);
  const bits = new Uint8Array(stride * height);
  for (let dot = 0; dot < width * height; ++dot) {
    if (rgba[4 * dot + 3] !== 0) continue;
    const row = Math.floor(dot / width);
    const column = dot - row * width;
    bits[row * stride + (column >> 3)]! |= 0x80 >> (column & 7);
  }
  return bits;
}

/** The images of a document. Embedded as pdf-lib does it, each would be packed twice. */
export class PdfImages {
  private count = 0;

  constructor(private readonly document: PDFDocument) {}

  /** The name of a new image in the page's resources. */
  key(page: PDFPage, image: PieceImage): PDFName {
    const key = PDFName.of(`Piece${++this.count}`);
    page.node.setXObject(key, this.embed(image.paint()));
    return key;
  }

  private embed(painted: PaintedPiece): PDFRef {
    const { context } = this.document;
    const { width, height } = painted;
    const image = { Type: 'XObject', Subtype: 'Image', Width: width, Height: height };
    const mask = context.stream(zlibSync(maskOf(painted)), {
      ...image,
      ImageMask: true,
      BitsPerComponent: 1,
      Filter: 'FlateDecode',
    });
    const values = coloursOf(painted.rgba);
    const bitsPerComponent = 8;
    const colours = context.stream(packedRows({ width, height, values, channels: 3 }), {
      ...image,
      ColorSpace: 'DeviceRGB',
      BitsPerComponent: bitsPerComponent,
      Filter: 'FlateDecode',
      // As PNG filters rows.
      DecodeParms: { Predictor: 15, Colors: 3, BitsPerComponent: bitsPerComponent, Columns: width },
      Mask: context.register(mask),
    });
    return context.register(colours);
  }
}
