import type { Message } from '../model/message.js';
import type { ModelFile } from '../model/model-files.js';
import { isTooLarge, mostPixels, pictureHeader } from '../model/picture-header.js';
import { isUsable, pictureKind } from './picture-kind.js';
import { notice } from './read-model.js';

/** MiB of all pictures together: a few photographs of the largest size that models have. */
const mostMegabytes = 64;

/** Far more than any model has; each may be a texture of its own on screen. */
const mostPictures = 256;

/** The pictures of a model, each once, and what is to be told of those that cannot be used. */
export class Pictures {
  /** Those that can be used, as their files hold them. */
  readonly files: ModelFile[] = [];
  private readonly numbers = new Map<string, number | null>();
  private readonly missing = new Set<string>();
  private readonly unread: { name: string; kind: string }[] = [];
  private readonly large: string[] = [];
  private bytes = 0;

  /**
   * Number of a picture in `files`; null for one that is missing or cannot be used.
   *
   * @param key tells pictures apart; `find` is called once for each
   * @param name as people know it
   * @param find gets its file; null if it did not come along, `large` if it is not even to be unpacked
   */
  add(key: string, name: string, find: () => ModelFile | 'large' | null): number | null {
    const known = this.numbers.get(key);
    if (known !== undefined) return known;
    const file = find();
    if (!file) this.missing.add(name);
    if (file === 'large') this.large.push(name);
    const number = file && file !== 'large' ? this.taken(file) : null;
    this.numbers.set(key, number);
    return number;
  }

  private taken({ name, bytes }: ModelFile): number | null {
    const kind = pictureKind(bytes);
    const header = pictureHeader(bytes);
    if (!isUsable(kind) || !header) {
      this.unread.push({ name, kind: isUsable(kind) ? '' : kind });
      return null;
    }
    const isTooMuch = this.bytes + bytes.length > mostMegabytes * 2 ** 20;
    if (isTooMuch || isTooLarge(header) || this.files.length === mostPictures) {
      this.large.push(name);
      return null;
    }
    this.bytes += bytes.length;
    return this.files.push({ name, bytes }) - 1;
  }

  get notices(): Message[] {
    const { missing, unread, large } = this;
    const notices: Message[] = [];
    if (missing.size > 0) {
      notices.push(notice('missing-looks', { what: 'pictures', files: [...missing] }));
    }
    if (unread.length > 0) {
      const files = unread.map(({ name }) => name);
      const kinds = [...new Set(unread.flatMap(({ kind }) => kind || []))];
      notices.push(notice('unread-pictures', { files, kinds }));
    }
    if (large.length > 0) {
      const most = { most: mostPictures, most_mb: mostMegabytes, most_pixels: mostPixels };
      notices.push(notice('large-pictures', { files: large, ...most }));
    }
    return notices;
  }
}
