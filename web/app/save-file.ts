import { make } from './dom.js';

/** Hands a file to the browser's own download. */
export function saveFile(name: string, content: string | Uint8Array, mediaType: string): void {
  // A copy in a plain ArrayBuffer, because bytes may be a view into something larger.
  const part = typeof content === 'string' ? content : new Uint8Array(content);
  const address = URL.createObjectURL(new Blob([part], { type: mediaType }));
  make('a', { href: address, download: name }).click();
  // The download reads the blob after this turn; a minute is plenty and still gives memory back.
  setTimeout(() => URL.revokeObjectURL(address), 60_000);
}
