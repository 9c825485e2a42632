/** Colours of the animals and the heart: names of materials, and a rule that gives each face its own; see `paint.mjs`. */

const whale = {
  colours: { back: '#4a95d1', belly: '#eef6f8', fins: '#2f74b5', eye: '#1f2f42' },
  of: ({ part, corners }) => {
    if (part !== 'body') return 'fins';
    // The belly is highest at the mouth.
    return corners.every(([, y, z]) => y < 0.1 * z - 0.18) ? 'belly' : 'back';
  },
  spots: { eye: [[0.5, 0.01, 1.52]] },
};

const duck = {
  colours: { feathers: '#ffd83d', wings: '#f9b52c', bill: '#f57c28', eye: '#2d2a38' },
  of: ({ part }) => ({ bill: 'bill', wing: 'wings' })[part] ?? 'feathers',
  spots: { eye: [[0.36, 1.06, 1.0]] },
};

const cat = {
  colours: {
    fur: '#f7a44c',
    stripes: '#d8762b',
    muzzle: '#fff3e0',
    ears: '#f9b7ad',
    nose: '#e5697c',
    eyes: '#4fb984',
  },
  of: ({ part, distance, corners, centre: [x, y] }) => {
    if (distance('eye') < 0.04) return 'eyes';
    if (distance('hollow') < 0.04) return 'ears';
    if (part === 'nose') return 'nose';
    if (part === 'muzzle') return 'muzzle';
    if (corners.every((p) => p[1] < -0.35 && p[2] > -0.1 && p[0] < 0.6)) return 'muzzle';
    return x < 0.2 && y > 0.35 ? 'stripes' : 'fur';
  },
};

const rabbit = {
  colours: {
    fur: '#c9a98d',
    belly: '#fdf3e6',
    ears: '#f6b1b4',
    nose: '#e98492',
    eye: '#38292b',
  },
  of: ({ part, centre: [, , z], normal }) => {
    if (part === 'tail') return 'belly';
    if (part === 'ear') return normal[2] > 0.3 ? 'ears' : 'fur';
    if (part === 'body' && z > 0.3) return 'belly';
    return 'fur';
  },
  spots: { eye: [[0.36, 1.05, 0.75]], nose: [[0.05, 0.85, 1.15]] },
};

const fish = {
  colours: { body: '#ff8a34', bands: '#fff6e8', fins: '#ea5a2a', eye: '#26323e', lips: '#ffc56b' },
  of: ({ part, corners }) => {
    if (part === 'eye') return 'eye';
    if (part === 'lips') return 'lips';
    if (['tail', 'dorsal', 'fin'].includes(part)) return 'fins';
    const within = (from, to) => corners.every(([, , z]) => z > from && z < to);
    return within(0.2, 0.75) || within(-0.62, -0.05) ? 'bands' : 'body';
  },
};

const heart = {
  colours: { pale: '#ffa3b5', pink: '#f56a86', red: '#e0304c' },
  of: ({ corners }) => {
    if (corners.every(([, y]) => y > 0.5)) return 'pale';
    return corners.every(([, y]) => y < 0.05) ? 'red' : 'pink';
  },
};

export const animalColours = { whale, duck, cat, rabbit, fish, heart };
