/** Where OBJ files have their materials. */

/** Longer names than any system has, several in a row. */
const longestLine = 4096;

/** Far more than any file names. */
const mostLibraries = 1000;

const lineEnd = 10;
const word = /^[ \t]*mtllib[ \t]+(\S.*)$/i;

/**
 * The rest of each `mtllib` line of an OBJ file, each once. Cost: a look at the beginning of each line; nothing
 * else of the file is understood.
 */
export function librariesIn(bytes: Uint8Array): string[] {
  const decoder = new TextDecoder();
  const found = new Set<string>();
  for (let begin = 0; begin < bytes.length && found.size < mostLibraries;) {
    const next = bytes.indexOf(lineEnd, begin);
    const end = next === -1 ? bytes.length : next;
    const isWorthALook = end - begin < longestLine && mayBeLibrary(bytes, begin);
    const name = isWorthALook && word.exec(decoder.decode(bytes.subarray(begin, end)).trim())?.[1];
    if (name) found.add(name);
    begin = end + 1;
  }
  return [...found];
}

/** Whether the first letter after blanks is an M. */
function mayBeLibrary(bytes: Uint8Array, begin: number): boolean {
  let at = begin;
  while (bytes[at] === 0x20 || bytes[at] === 0x09) ++at;
  return bytes[at] === 0x6d || bytes[at] === 0x4d;
}

/** What a line may name: one file, whose name may have blanks, or several. */
export function namesOfLine(line: string): string[] {
  const several = line.split(/(?<=\.mtl)\s+/i).map((name) => name.trim());
  return several.length > 1 ? [line, ...several] : [line];
}
