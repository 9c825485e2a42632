/** Writers of the samples' files. */
import { normalize, triangleNormal } from './vector.mjs';

const digits = (value) => String(Number(value.toFixed(5)) + 0);

/** Wavefront OBJ with polygons as they are. */
export function toObj(name, { vertices, faces }) {
  const lines = [
    `# ${name}, a Foldwright sample`,
    ...vertices.map((p) => `v ${p.map(digits).join(' ')}`),
    ...faces.map((face) => `f ${face.map((v) => v + 1).join(' ')}`),
  ];
  return `${lines.join('\n')}\n`;
}

/** Binary STL; the faces must be triangles. */
export function toStl({ vertices, faces }) {
  const bytes = Buffer.alloc(84 + 50 * faces.length);
  bytes.write('a Foldwright sample');
  bytes.writeUInt32LE(faces.length, 80);
  faces.forEach((face, f) => {
    const corners = face.map((v) => vertices[v]);
    const numbers = [normalize(triangleNormal(...corners)), ...corners].flat();
    numbers.forEach((value, i) => bytes.writeFloatLE(value, 84 + 50 * f + 4 * i));
  });
  return bytes;
}
