/** Paths as files name each other by. */

/** `a/./b/../c.png` as `a/c.png`; null for one that leads out of the folder, or to another place altogether. */
export function normalized(path: string): string | null {
  const parts: string[] = [];
  const slashed = path.replaceAll('\\', '/');
  if (/^(?:[a-z][a-z0-9+.-]*:|\/)/i.test(slashed)) return null;
  for (const part of slashed.split('/')) {
    if (part === '' || part === '.') continue;
    if (part !== '..') parts.push(part);
    else if (parts.pop() === undefined) return null;
  }
  return parts.join('/');
}

/** The folder of a file, with a slash behind; empty for one that lies in none. */
export function folderOf(name: string): string {
  return name.replaceAll('\\', '/').replace(/[^/]*$/, '');
}

/** Addresses have bytes as %20; names of files may have a percent sign of their own. */
export function decoded(address: string): string {
  try {
    return decodeURIComponent(address);
  } catch {
    return address;
  }
}
