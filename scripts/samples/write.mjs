/** Writers of the samples' files. */

const digits = (value) => String(Number(value.toFixed(5)) + 0);

/** Faces as lines, with the name of their material before those whose material is another than that of the face before. */
function faceLines(faces, materials) {
  return faces.flatMap((face, i) => {
    const line = `f ${face.map((v) => v + 1).join(' ')}`;
    return materials[i] === materials[i - 1] ? [line] : [`usemtl ${materials[i]}`, line];
  });
}

/**
 * Wavefront OBJ with polygons as they are, in their order.
 *
 * @param library name of the file with the materials
 * @param materials name of the material of each face
 */
export function toObj(name, { vertices, faces }, library, materials) {
  const lines = [
    `# ${name}, a Foldwright sample`,
    `mtllib ${library}`,
    ...vertices.map((p) => `v ${p.map(digits).join(' ')}`),
    ...faceLines(faces, materials),
  ];
  return `${lines.join('\n')}\n`;
}

/** @param colours `#rrggbb` by the names of materials */
export function toMtl(name, colours) {
  const shares = (colour) =>
    [1, 3, 5].map((at) => (parseInt(colour.slice(at, at + 2), 16) / 255).toFixed(4));
  const materials = Object.entries(colours).map(
    ([material, colour]) => `\nnewmtl ${material}\nKd ${shares(colour).join(' ')}\n`,
  );
  return `# ${name}, a Foldwright sample\n${materials.join('')}`;
}
