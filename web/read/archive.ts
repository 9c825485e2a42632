/** Unpacks ZIP archives within bounds. Nothing is written anywhere, so names cannot lead out of them. */
import { FileLimits, isHidden, type ModelFile } from '../model/model-files.js';
import { remainder } from '../model/png-file.js';
import type { FileSource } from './companions.js';
import { inflated } from './inflate.js';
import { normalized } from './paths.js';
import type { ArchiveFault } from '../words/messages.js';
import { Unreadable, unreadable } from './unreadable.js';
import { BrokenZip, packedBytes, ZipBytes, zipEntries, type ZipEntry } from './zip-directory.js';

/**
 * Times its size that an archive may come to. Models as text become up to 20 times smaller; a bomb comes
 * near to 1032, which is as far as the format goes.
 */
const mostGrowth = 200;

/** What is smaller does no harm, however it is packed. In bytes. */
const harmless = 16 * 2 ** 20;

/** Files of any kind; far more are in no archive of a model. */
const mostEntries = 20_000;

/** The path of an entry in the archive; null for a folder, and for one that leads elsewhere. */
function pathOf({ name }: ZipEntry): string | null {
  return /[/\\]$/.test(name) ? null : normalized(name);
}

/** Whether a person put a file there, and not a system. */
export function isOfPerson(path: string): boolean {
  return !isHidden(path) && !/(?:^|\/)(?:__MACOSX\/|Thumbs\.db$|desktop\.ini$)/i.test(path);
}

function contentOf(zip: ZipBytes, entry: ZipEntry): Uint8Array {
  const packed = packedBytes(zip, entry);
  const bytes = entry.method === 0 ? packed.slice() : inflated(packed, entry.size);
  if (remainder(bytes) !== entry.checksum) throw new BrokenZip();
  return bytes;
}

/** The files in an archive, which are unpacked when they are asked for. */
export class Archive implements FileSource {
  private readonly zip: ZipBytes;
  private readonly entries = new Map<string, ZipEntry>();
  private readonly limits = new FileLimits();
  private unpacked = 0;

  /**
   * @param entriesOf where to look for what is in it
   * @throws Unreadable if its list is damaged, or longer than any of a model
   */
  constructor(
    private readonly file: ModelFile,
    private readonly entriesOf: (zip: ZipBytes) => Iterable<ZipEntry> = zipEntries,
  ) {
    this.zip = new ZipBytes(file.bytes);
    this.guarded(() => this.list());
  }

  /** Paths in the archive, with slashes. */
  get paths(): string[] {
    return [...this.entries.keys()];
  }

  /** @throws Unreadable if it cannot be unpacked, or all so far come to too much @pre it is one of `paths` */
  read(path: string): ModelFile {
    const entry = this.entries.get(path)!;
    this.check(entry);
    return { name: path, bytes: this.guarded(() => contentOf(this.zip, entry)) };
  }

  private list(): void {
    let count = 0;
    for (const entry of this.entriesOf(this.zip)) {
      if (++count > mostEntries) {
        this.refuse({ what: 'too-many', most: mostEntries });
      }
      const path = pathOf(entry);
      if (path !== null) this.entries.set(path, entry);
    }
  }

  /** Refuses what is too much before it is unpacked. */
  private check({ name: entry, isLocked, method, size }: ZipEntry): void {
    if (isLocked) this.refuse({ what: 'locked', entry });
    if (method !== 0 && method !== 8) this.refuse({ what: 'method', entry });
    this.unpacked += size;
    const isSwollen = this.unpacked > mostGrowth * this.file.bytes.length;
    if (isSwollen && this.unpacked > harmless) this.refuse({ what: 'bomb' });
    const excess = this.limits.add(size);
    if (excess !== null) this.refuse(excess);
  }

  private refuse(fault: ArchiveFault): never {
    throw unreadable('bad-archive', { file: this.file.name, ...fault });
  }

  private guarded<Value>(work: () => Value): Value {
    try {
      return work();
    } catch (error) {
      if (error instanceof Unreadable) throw error;
      // Both the list and the packed bytes fail in many ways, which all mean the same.
      return this.refuse({ what: 'damaged' });
    }
  }
}
