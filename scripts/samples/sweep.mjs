/** Tubes along closed curves. */
import { add, cross, dot, normalize, scale, subtract } from './vector.mjs';

/**
 * Sweeps a regular polygon along a closed curve as quads; frames are carried along and the twist
 * that is left over at the seam is spread over all rings.
 *
 * @param centre the curve as a function of [0, 2 pi)
 * @param radius of the polygon's corners
 * @param around number of rings
 * @param sides corners of the polygon
 * @param up any direction that the curve does not start along
 */
export function sweep(centre, radius, around, sides, up = [0, 0, 1]) {
  const parameter = (i) => (2 * Math.PI * i) / around;
  const centres = Array.from({ length: around }, (_, i) => centre(parameter(i)));
  const tangents = centres.map((_, i) =>
    normalize(subtract(centres[(i + 1) % around], centres[(i + around - 1) % around])),
  );
  const frames = carryFrames(tangents, up);
  const twist = closingTwist(tangents, frames, sides);
  const vertices = centres.flatMap((c, i) =>
    Array.from({ length: sides }, (_, s) => {
      const angle = (2 * Math.PI * s) / sides + (twist * i) / around;
      const side = cross(tangents[i], frames[i]);
      const offset = add(scale(frames[i], Math.cos(angle)), scale(side, Math.sin(angle)));
      return add(c, scale(offset, radius));
    }),
  );
  const shift = Math.round((twist - exactTwist(tangents, frames)) / ((2 * Math.PI) / sides));
  const faces = [];
  for (let i = 0; i < around; i++) {
    const next = (i + 1) % around;
    // The last ring meets the first one turned by whole sides.
    const turn = next === 0 ? shift : 0;
    const at = (ring, s) => ring * sides + (((s % sides) + sides) % sides);
    for (let s = 0; s < sides; s++) {
      faces.push([at(i, s), at(i, s + 1), at(next, s + 1 + turn), at(next, s + turn)]);
    }
  }
  return { vertices, faces };
}

/** Frames perpendicular to the tangents, each the projection of the one before. */
function carryFrames(tangents, up) {
  let frame = up;
  return tangents.map((tangent) => {
    frame = normalize(subtract(frame, scale(tangent, dot(frame, tangent))));
    return frame;
  });
}

/** The angle by which the carried frame misses the first one after a full turn. */
function exactTwist(tangents, frames) {
  const last = carryFrames([tangents.at(-1), tangents[0]], frames.at(-1))[1];
  const side = cross(tangents[0], frames[0]);
  return -Math.atan2(dot(last, side), dot(last, frames[0]));
}

/** The least twist after which the polygon meets itself again, by whole sides. */
function closingTwist(tangents, frames, sides) {
  const miss = exactTwist(tangents, frames);
  const sector = (2 * Math.PI) / sides;
  return miss - Math.round(miss / sector) * sector;
}
