// A call takes so many arguments in every browser.
const chunk = 32_768;

/** Bytes as the text that addresses of data hold. */
export function base64(bytes: Uint8Array): string {
  const letters: string[] = [];
  for (let at = 0; at < bytes.length; at += chunk) {
    letters.push(String.fromCharCode(...bytes.subarray(at, at + chunk)));
  }
  return btoa(letters.join(''));
}
