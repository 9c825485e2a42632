import { getDocument, OPS } from 'pdfjs-dist/legacy/build/pdf.mjs';

/** A stroked path of a page in mm, from the lower left; closed paths end where they began. */
export interface PdfLine {
  width: number;
  dash: number[];
  points: number[][];
}

export interface PdfPage {
  width: number;
  height: number;
  lines: PdfLine[];
  text: string[];
}

const millimetres = 25.4 / 72;

/** What pdf.js encodes in a path, besides the curves that do not occur here. */
const pathStep = { moveTo: 0, lineTo: 1, close: 4 };

function pathsOf(data: ArrayLike<number>): number[][][] {
  const paths: number[][][] = [];
  for (let i = 0; i < data.length;) {
    const step = data[i];
    if (step === pathStep.close) {
      paths.at(-1)!.push(paths.at(-1)![0]!);
      i += 1;
      continue;
    }
    if (step !== pathStep.moveTo && step !== pathStep.lineTo) throw new Error(`step ${step}`);
    const point = [data[i + 1]! * millimetres, data[i + 2]! * millimetres];
    if (step === pathStep.moveTo) paths.push([point]);
    else paths.at(-1)!.push(point);
    i += 3;
  }
  return paths;
}

/** Reads a PDF back page by page with pdf.js. */
export async function readPdf(bytes: Uint8Array): Promise<{ pages: PdfPage[]; scaling: unknown }> {
  const task = getDocument({ data: bytes.slice(), useSystemFonts: false, verbosity: 0 });
  const document = await task.promise;
  const preferences: { PrintScaling?: unknown } | null = await document.getViewerPreferences();
  const pages: PdfPage[] = [];
  for (let number = 1; number <= document.numPages; ++number) {
    const page = await document.getPage(number);
    const { fnArray, argsArray } = await page.getOperatorList();
    const lines: PdfLine[] = [];
    let state = { width: 0, dash: [] as number[] };
    fnArray.forEach((operator, i) => {
      const values = argsArray[i] as unknown[];
      if (operator === OPS.setLineWidth)
        state = { ...state, width: Number(values[0]) * millimetres };
      if (operator === OPS.setDash) {
        state = { ...state, dash: (values[0] as number[]).map((value) => value * millimetres) };
      }
      if (operator !== OPS.constructPath) return;
      const [data] = values[1] as [ArrayLike<number>];
      for (const points of pathsOf(data)) lines.push({ ...state, points });
    });
    const content = await page.getTextContent();
    const text = content.items.flatMap((item) => ('str' in item && item.str ? [item.str] : []));
    const [, , width, height] = page.view;
    pages.push({ width: width! * millimetres, height: height! * millimetres, lines, text });
  }
  await task.destroy();
  return { pages, scaling: preferences?.PrintScaling };
}
