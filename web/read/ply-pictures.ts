/** Far behind the end of any header. */
const longestHeader = 65_536;

/** Names of the pictures in the header of a PLY file, as programs note them there: "comment TextureFile wood.png". */
export function plyPictures(bytes: Uint8Array): string[] {
  const begin = new TextDecoder().decode(bytes.subarray(0, longestHeader));
  if (!/^ply\s/.test(begin)) return [];
  const [header = ''] = begin.split('end_header', 1);
  const comments = header.matchAll(/^comment[ \t]+TextureFile[ \t]+(\S.*)$/gim);
  return [...comments].map(([, name]) => name!.trim());
}
