/**
 * The gallery's organic models as implicit solids, y up and looking towards +z, each with the parts by which its faces
 * are coloured. Each names the box it lives in, the grid that catches its thinnest part, and how many triangles it keeps.
 */
import {
  blendUnion,
  carve,
  chain,
  ellipsoid,
  halfSpace,
  mirrored,
  roundCone,
} from './implicit.mjs';

function whale() {
  const body = blendUnion(
    0.35,
    ellipsoid([0, 0, 0.55], [0.82, 0.72, 1.25]),
    chain(
      [
        [0, 0, 0.2, 0.62],
        [0, 0.02, -0.9, 0.4],
        [0, 0.28, -1.65, 0.2],
        [0, 0.72, -2.1, 0.12],
      ],
      0.3,
    ),
  );
  const fluke = ellipsoid([0.42, 0.86, -2.38], [0.55, 0.09, 0.24], [22, 32, 14]);
  const flipper = ellipsoid([0.98, -0.42, 0.5], [0.58, 0.1, 0.25], [10, 30, -24]);
  const belly = halfSpace([0, -1, 0], 0.56);
  const solid = blendUnion(0.16, body, fluke, flipper);
  return { solid: carve(0.1, solid, (p) => -belly(p)), parts: { body, fluke, flipper } };
}

function duck() {
  const body = blendUnion(
    0.4,
    ellipsoid([0, 0, 0], [0.72, 0.6, 0.98]),
    chain(
      [
        [0, 0.1, -0.6, 0.38],
        [0, 0.52, -1.25, 0.07],
      ],
      0.2,
    ),
  );
  const neck = roundCone([0, 0.25, 0.55], [0, 0.85, 0.66], 0.36, 0.3);
  const head = ellipsoid([0, 1.05, 0.72], [0.4, 0.4, 0.44]);
  const bill = ellipsoid([0, 0.95, 1.22], [0.24, 0.09, 0.32], [6, 0, 0]);
  const wing = ellipsoid([0.68, 0.14, -0.16], [0.14, 0.34, 0.62], [-14, 0, -10]);
  const solid = blendUnion(0.1, blendUnion(0.22, body, neck, head), bill, wing);
  return {
    solid: carve(0.08, solid, halfSpace([0, 1, 0], -0.48)),
    parts: { body, neck, head, bill, wing },
  };
}

function cat() {
  const head = ellipsoid([0, 0, 0], [1, 0.84, 0.78]);
  const cheek = ellipsoid([0.52, -0.26, 0.2], [0.5, 0.4, 0.46]);
  const ear = roundCone([0.52, 0.5, -0.05], [0.78, 1.28, -0.02], 0.36, 0.05);
  const hollow = roundCone([0.56, 0.62, 0.36], [0.76, 1.14, 0.14], 0.2, 0.03);
  const muzzle = ellipsoid([0.16, -0.3, 0.72], [0.25, 0.19, 0.22]);
  const nose = ellipsoid([0, -0.13, 0.9], [0.12, 0.08, 0.1]);
  const eye = ellipsoid([0.4, 0.1, 0.78], [0.19, 0.13, 0.16], [0, 0, 14]);
  const skull = carve(0.08, blendUnion(0.14, blendUnion(0.3, head, cheek), ear), hollow);
  return {
    solid: carve(0.06, blendUnion(0.08, skull, muzzle, nose), eye),
    parts: { head, cheek, ear, hollow, muzzle, nose, eye },
  };
}

function rabbit() {
  const body = blendUnion(
    0.3,
    ellipsoid([0, 0, -0.2], [0.66, 0.66, 0.84]),
    ellipsoid([0, 0.2, 0.34], [0.46, 0.52, 0.46]),
  );
  const haunch = ellipsoid([0.5, -0.24, -0.36], [0.3, 0.44, 0.52]);
  const foot = roundCone([0.46, -0.56, -0.2], [0.46, -0.58, 0.42], 0.18, 0.14);
  const paw = roundCone([0.22, -0.1, 0.6], [0.22, -0.58, 0.8], 0.17, 0.13);
  const head = blendUnion(
    0.2,
    ellipsoid([0, 0.92, 0.58], [0.42, 0.4, 0.48]),
    ellipsoid([0, 0.8, 0.92], [0.24, 0.2, 0.24]),
  );
  const ear = ellipsoid([0.24, 1.62, 0.28], [0.15, 0.62, 0.1], [-18, 0, -12]);
  const tail = ellipsoid([0, 0.12, -1.08], [0.24, 0.24, 0.24]);
  const solid = blendUnion(0.12, blendUnion(0.2, body, head), haunch, foot, paw, ear, tail);
  return {
    solid: carve(0.05, solid, halfSpace([0, 1, 0], -0.66)),
    parts: { body, haunch, foot, paw, head, ear, tail },
  };
}

function heart() {
  const lobe = ellipsoid([0.46, 0.36, 0], [0.58, 0.66, 0.46], [0, 0, -24]);
  const tip = roundCone([0.36, 0.16, 0], [0, -0.98, 0], 0.46, 0.06);
  return { solid: blendUnion(0.12, lobe, tip), parts: { lobe, tip } };
}

function fish() {
  const body = ellipsoid([0, 0, 0.2], [0.46, 0.72, 1.1]);
  const stem = roundCone([0, 0, -0.5], [0, 0, -1.1], 0.36, 0.14);
  const tail = blendUnion(
    0.08,
    ellipsoid([0, 0.4, -1.48], [0.08, 0.2, 0.56], [52, 0, 0]),
    ellipsoid([0, -0.4, -1.48], [0.08, 0.2, 0.56], [-52, 0, 0]),
  );
  const dorsal = ellipsoid([0, 0.74, -0.02], [0.09, 0.34, 0.62], [-14, 0, 0]);
  const fin = ellipsoid([0.5, -0.22, 0.14], [0.09, 0.2, 0.42], [24, -34, 0]);
  const lips = ellipsoid([0, -0.06, 1.28], [0.17, 0.16, 0.14]);
  const eye = ellipsoid([0.36, 0.18, 0.82], [0.1, 0.14, 0.14]);
  return {
    solid: blendUnion(0.12, blendUnion(0.2, body, stem), tail, dorsal, fin, lips, eye),
    parts: { body, stem, tail, dorsal, fin, lips, eye },
  };
}

/** Name, solid with its parts, box, grid step and triangles of every organic model. */
export const ANIMALS = [
  ['whale', 'Whale', whale, [-1.9, -1, -3.2], [1.9, 1.9, 2], 0.075, 420],
  ['duck', 'Duck', duck, [-1.1, -0.9, -1.6], [1.1, 1.7, 1.8], 0.052, 360],
  ['cat', 'Cat', cat, [-1.4, -1.1, -1], [1.4, 1.6, 1.3], 0.052, 480],
  ['rabbit', 'Rabbit', rabbit, [-1.2, -1, -1.6], [1.2, 2.6, 1.5], 0.06, 560],
  ['fish', 'Fish', fish, [-1, -1.4, -2.3], [1, 1.4, 1.7], 0.052, 380],
  ['heart', 'Heart', heart, [-1.3, -1.4, -0.8], [1.3, 1.3, 0.8], 0.052, 240],
].map(([id, name, make, min, max, step, triangles]) => {
  const { solid, parts } = make();
  return { id, name, solid: mirrored(solid), parts, min, max, step, triangles };
});
