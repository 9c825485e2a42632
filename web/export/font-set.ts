import { create, type Font } from 'fontkit';
import type { FontLoader } from './font-loader.js';
import { fontSlices } from './font-slices.js';

/** Neighbouring letters that one file has; `slice` is -1 for one that none has. */
export interface FontRun {
  letters: string;
  slice: number;
}

interface LoadedSlice {
  bytes: Uint8Array;
  font: Font;
}

// What people see as one sign: flags, and pictures with their colours, marks and companions.
const signs =
  /\p{RI}\p{RI}|\p{Extended_Pictographic}(?:\p{EMod}|\uFE0F|\u20E3|\u200D\p{Extended_Pictographic})*|./gsu;

/** The signs of a text, in order. */
export function signsOf(text: string): string[] {
  return text.match(signs) ?? [];
}

/** The fonts that some texts need, and no others. */
export class FontSet {
  private readonly slices: LoadedSlice[] = [];
  /** Per sign: its slice, or -1. */
  private readonly places = new Map<string, number>();

  /** Loads what the texts need of the fonts that come along. */
  static async load(texts: readonly string[], load: FontLoader): Promise<FontSet> {
    const set = new FontSet();
    const loaded = new Map<string, number>();
    for (const sign of new Set(texts.flatMap(signsOf))) {
      set.places.set(sign, await set.find(sign, loaded, load));
    }
    return set;
  }

  private async find(sign: string, loaded: Map<string, number>, load: FontLoader): Promise<number> {
    const letter = sign.codePointAt(0)!;
    // A picture of several letters would fall apart into them.
    if (sign.length > String.fromCodePoint(letter).length) return -1;
    for (const { file, has } of fontSlices) {
      if (!has(letter)) continue;
      if (!loaded.has(file)) {
        const bytes = await load(file);
        // Its types ask for a Buffer, which is one.
        loaded.set(file, this.slices.push({ bytes, font: create(bytes as Buffer) as Font }) - 1);
      }
      const slice = loaded.get(file)!;
      if (this.slices[slice]!.font.hasGlyphForCodePoint(letter)) return slice;
    }
    return -1;
  }

  /** Signs that no font has. */
  get missing(): string[] {
    return [...this.places].filter(([, slice]) => slice < 0).map(([sign]) => sign);
  }

  /** The files that were loaded; runs count them from 0. */
  get files(): readonly Uint8Array[] {
    return this.slices.map(({ bytes }) => bytes);
  }

  font(slice: number): Font {
    return this.slices[slice]!.font;
  }

  /** Divides a text, which must be among those that fonts were loaded for. */
  runs(text: string): FontRun[] {
    const runs: FontRun[] = [];
    for (const sign of signsOf(text)) {
      const slice = this.places.get(sign) ?? -1;
      const last = runs.at(-1);
      if (last?.slice === slice && slice >= 0) last.letters += sign;
      else runs.push({ letters: sign, slice });
    }
    return runs;
  }
}
