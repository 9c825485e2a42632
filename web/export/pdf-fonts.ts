import { create, type Font } from 'fontkit';
import type { PDFDocument, PDFFont, PDFName, PDFPage } from 'pdf-lib';
import type { FontRun, FontSet } from './font-set.js';
import { missingWidth } from './missing-sign.js';

type Fontkit = Parameters<PDFDocument['registerFontkit']>[0];

/** What pdf-lib wants of a subset; fontkit's own gives all bytes at once. */
interface SubsetStream {
  on(event: 'data' | 'end' | 'error', tell: (bytes: Uint8Array) => void): SubsetStream;
}

function streamOf(bytes: Uint8Array): SubsetStream {
  const stream: SubsetStream = {
    on(event, tell) {
      if (event !== 'error') tell(bytes);
      return stream;
    },
  };
  return stream;
}

/** pdf-lib was written for an earlier fontkit, whose subsets came as streams. */
const fontkit = {
  create(bytes: Uint8Array): Font {
    const font = create(bytes as Buffer) as Font;
    const createSubset = font.createSubset.bind(font);
    font.createSubset = () => {
      const subset = createSubset();
      const encode = (): Uint8Array => (subset as unknown as { encode(): Uint8Array }).encode();
      return Object.assign(subset, { encodeStream: () => streamOf(encode()) });
    };
    return font;
  },
};

/** The fonts of a document: of each only the letters that are used, embedded. */
export class PdfFonts {
  private readonly keys = new Map<PDFPage, PDFName[]>();

  private constructor(
    private readonly fonts: PDFFont[],
    /** What they were made of. */
    readonly set: FontSet,
  ) {}

  static async embed(document: PDFDocument, set: FontSet): Promise<PdfFonts> {
    document.registerFontkit(fontkit as unknown as Fontkit);
    const fonts: PDFFont[] = [];
    for (const [slice, bytes] of set.files.entries()) {
      fonts.push(
        await document.embedFont(bytes, {
          subset: true,
          // The tag that marks subsets, one for each.
          customName: `SLICE${String.fromCharCode(65 + slice)}+${set.font(slice).postscriptName}`,
          // Letters stand as they are written, where labels were given room.
          features: { kern: false, liga: false, clig: false, calt: false },
        }),
      );
    }
    return new PdfFonts(fonts, set);
  }

  font(slice: number): PDFFont {
    return this.fonts[slice]!;
  }

  /** The name of a font in the page's resources. */
  key(page: PDFPage, slice: number): PDFName {
    const keys = this.keys.get(page) ?? [];
    this.keys.set(page, keys);
    const font = this.font(slice);
    return (keys[slice] ??= page.node.newFontDictionary(font.name, font.ref));
  }

  runs(text: string): FontRun[] {
    return this.set.runs(text);
  }

  /** Width of a run over the size of the font. */
  width({ letters, slice }: FontRun): number {
    return slice < 0 ? missingWidth : this.font(slice).widthOfTextAtSize(letters, 1);
  }
}
