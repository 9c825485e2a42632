/** Sheets of results that were made here, with the fonts as they come from their packages. */
import { readFile } from 'node:fs/promises';
import { preparePrint, type Print, type PrintInput } from '../../web/export/print.js';
import type { JobResult } from '../../web/model/job.js';
import { defaultPrint, type PrintOptions } from '../../web/model/print-options.js';

const fonts = new URL('../../node_modules/@fontsource/', import.meta.url);

/** Reads a font; which ones were read is noted in `loaded`, if given. */
export function fontReader(loaded: string[] = []): (file: string) => Promise<Uint8Array> {
  return async (file) => {
    loaded.push(file);
    const font = file.startsWith('noto-sans') ? 'noto-sans' : 'biz-udpgothic';
    return new Uint8Array(await readFile(new URL(`${font}/files/${file}`, fonts)));
  };
}

const modules = {
  resvg: '@resvg/resvg-wasm/index_bg.wasm',
  webp: '@jsquash/webp/codec/dec/webp_dec.wasm',
} as const;

/** The renderer of PNG files and the reader of WebP files, as they come from their packages. */
export async function readRenderer(module: keyof typeof modules): Promise<Uint8Array> {
  const file = `../../node_modules/${modules[module]}`;
  return new Uint8Array(await readFile(new URL(file, import.meta.url)));
}

export interface PrintWishes extends Partial<Omit<PrintInput, 'options' | 'result'>> {
  options?: Partial<PrintOptions>;
}

/** The sheets of a result, by default of a model named 'cube' with margins of 10 mm. */
export function printOf(
  result: JobResult,
  { title = 'cube', margin = 10, options = {}, loadFont = fontReader() }: PrintWishes = {},
): Promise<Print> {
  return preparePrint({
    result,
    title,
    margin,
    loadFont,
    loadRenderer: readRenderer,
    options: { ...defaultPrint, ...options },
  });
}
