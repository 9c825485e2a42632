/** Refuses a sample that is not a closed, consistently oriented manifold with outward faces. */
import { cross, dot } from './vector.mjs';

/** @throws {Error} naming the sample and what is wrong with it */
export function checkSolid(name, { vertices, faces }) {
  const fail = (reason) => {
    throw new Error(`sample ${name}: ${reason}`);
  };
  const seen = new Set();
  for (const face of faces) {
    face.forEach((from, i) => {
      const key = `${from} ${face[(i + 1) % face.length]}`;
      if (seen.has(key)) fail(`directed edge ${key} occurs twice`);
      seen.add(key);
    });
  }
  for (const key of seen) {
    if (!seen.has(key.split(' ').reverse().join(' '))) fail(`edge ${key} is open`);
  }
  checkFans(faces, vertices.length, fail);
  if (volume({ vertices, faces }) <= 0) fail('faces look inwards');
}

/** Every vertex must have one closed fan of faces around it. */
function checkFans(faces, vertexCount, fail) {
  const next = Array.from({ length: vertexCount }, () => new Map());
  for (const face of faces) {
    face.forEach((v, i) => {
      next[v].set(face[(i + 1) % face.length], face[(i + face.length - 1) % face.length]);
    });
  }
  next.forEach((turns, v) => {
    if (turns.size === 0) fail(`vertex ${v} is in no face`);
    const [first] = turns.keys();
    let steps = 0;
    for (let w = first; steps === 0 || w !== first; w = turns.get(w)) steps++;
    if (steps !== turns.size) fail(`vertex ${v} joins two surfaces`);
  });
}

function volume({ vertices, faces }) {
  let sum = 0;
  for (const face of faces) {
    for (let i = 2; i < face.length; i++) {
      const [a, b, c] = [face[0], face[i - 1], face[i]].map((v) => vertices[v]);
      sum += dot(a, cross(b, c)) / 6;
    }
  }
  return sum;
}
