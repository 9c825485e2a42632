import { readdirSync, statSync } from 'node:fs';
import { join } from 'node:path';

function namesIn(folder: string): string[] {
  try {
    return readdirSync(folder);
  } catch {
    return [];
  }
}

/** A path within a folder as the disk has it: systems differ in what they tell apart, so cases of letters may differ. */
function spelled(folder: string, path: string): string | null {
  const found: string[] = [];
  for (const part of path.split('/')) {
    const names = namesIn(join(folder, ...found));
    const wanted = part.toLowerCase();
    const name = names.includes(part) ? part : names.find((each) => each.toLowerCase() === wanted);
    if (name === undefined) return null;
    found.push(name);
  }
  return found.join('/');
}

/** The first of some paths within a folder at which a file lies; null if none does. Cost: a look at its folders. */
export function placeOnDisk(folder: string, paths: readonly string[]): string | null {
  for (const path of paths) {
    const place = spelled(folder, path);
    // What is no file, such as a device, might never end.
    if (place !== null && statSync(join(folder, place), { throwIfNoEntry: false })?.isFile()) {
      return place;
    }
  }
  return null;
}
