/** Texts in PDO files. */
import type { PdoBytes } from './pdo-bytes.js';

/** How a file has its texts. */
export interface TextForm {
  /** Two bytes per letter (UTF-16), or one of the code pages of Windows. */
  isWide: boolean;
  /** Added to each byte, modulo 256. */
  shift: number;
}

export const unshifted: TextForm = { isWide: false, shift: 0 };

/** Most of these files are Japanese, and what they say of their code page is often wrong or nothing. */
const codePages = ['utf-8', 'shift_jis'] as const;

function decoded(bytes: Uint8Array): string {
  for (const page of codePages) {
    try {
      return new TextDecoder(page, { fatal: true }).decode(bytes);
    } catch {
      continue;
    }
  }
  return new TextDecoder('windows-1252').decode(bytes);
}

/** A text with its length in front. */
export function readText(bytes: PdoBytes, { isWide, shift }: TextForm): string {
  const stored = bytes.block(bytes.count(1));
  // The zero byte behind narrow letters is not shifted as they are; behind wide ones it is, and is cut off below.
  const letters = isWide ? stored : stored.subarray(0, -1);
  const plain = letters.map((byte) => byte - shift);
  const text = isWide ? new TextDecoder('utf-16le').decode(plain) : decoded(plain);
  return text.split('\0', 1)[0]!;
}

export function skipText(bytes: PdoBytes): void {
  bytes.skip(bytes.count(1));
}
