/** Where in the output folder the files of a model lie, and what they are called. */
import { createHash } from 'node:crypto';
import { basename, isAbsolute, join, relative, sep } from 'node:path';

/** Longer names no disk takes; in bytes. */
const mostBytes = 255;

/** What stands behind a name that is not the path itself: two of these are the same for one in 4 billion pairs. */
const digits = 8;

/** Characters that some disk or address takes for something else, and dots that hide a folder. */
// eslint-disable-next-line no-control-regex
const unsafe = /[\u0000-\u001f\u007f<>:"|?*\\%#]|^\.+|[. ]+$/g;

/** A part of a path as a name that any disk takes. */
function safe(part: string): string {
  const name = part.replace(unsafe, (found) => '_'.repeat(found.length));
  // Room for the digits, and for what is put around a name while its folder is not complete.
  const room = mostBytes - 24;
  let [short, bytes] = ['', 0];
  for (const letter of name) {
    bytes += Buffer.byteLength(letter);
    if (bytes > room) break;
    short += letter;
  }
  return short;
}

/** A path with slashes, as it stands from `base` on, or as a whole where it lies outside. */
export function labelOf(path: string, base: string): string {
  const within = relative(base, path);
  const isWithin = within !== '' && within !== '..' && !within.startsWith(`..${sep}`);
  const label = isWithin && !isAbsolute(within) ? within : path;
  return label.split(sep).join('/');
}

/**
 * Names the folder of a model by its path, with slashes: as it stands from `base` on, where that is possible. Other
 * models do not matter, so that a list may grow. Paths that lie outside `base` or have unusual characters get digits
 * behind them, so that no two are the same.
 */
export function folderName(path: string, base: string): string {
  const label = labelOf(path, base);
  const name = label
    .split('/')
    .filter((part) => part !== '')
    .map(safe)
    .join('/');
  if (name === label) return name;
  const hash = createHash('sha256').update(path).digest('hex').slice(0, digits);
  return `${name}-${hash}`;
}

/** The path of a model's folder, or of something in it. */
export function placeOf(out: string, name: string, file = ''): string {
  return join(out, ...name.split('/'), file);
}

/** What the files of a model are called, without ending. */
export function fileTitle(name: string): string {
  return basename(name).replace(/(?<=.)\.[^.]*$/, '');
}

/** What a model's record is called; no other file of the model is. */
export function recordName(name: string): string {
  return `${fileTitle(name)}.record.json`;
}

/** What a model's picture is called; no other file of the model is. */
export function pictureName(name: string): string {
  return `${fileTitle(name)}.picture.png`;
}
