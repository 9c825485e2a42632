// What the picture of each option shows: a scene, the values of the option side by side, and the window of the sheet.
// An option without a picture has the reason in its place. `make.mjs` fails for an option that is not here.

/** A corner of the box with a cut, folds, a flap and a number. */
const corner = { at: [0.3, 0.72], size: [66, 44] };

/** One of several sides, from near. */
const near = { at: [0.5, 0.5], size: [66, 44] };

/** A flap from very near. */
const flap = { at: [0.3, 0.8], size: [36, 24] };

/** Of the drum: the rim of a lid, and some folds of its wall. */
const rim = { at: [0.08, 0.93], size: [36, 24] };
const wall = { at: [0.5, 0.45], size: [48, 32] };

export const scenes = {
  box: { model: 'box', options: { height: 40 } },
  'open box': { model: 'open box', options: { height: 40 } },
  nested: { model: 'box in a box', options: { height: 40 } },
  crossed: { model: 'box with a bar', options: { height: 40, parts: 1 } },
  stud: { model: 'box with a stud', options: { height: 40 } },
  drum: { model: 'drum', options: { height: 30 } },
  painted: { model: 'painted', options: { height: 40 } },
  house: { model: 'house', options: {} },
  // Its own colours would draw the eye away from the lines.
  star: { model: 'star', options: { up: 'y', texture: 'off' } },
  heart: { model: 'heart', options: { faces: 80, parts: 3, height: 80, colour: 'part' } },
  rabbit: { model: 'rabbit', options: { faces: 160, parts: 6, height: 120, colour: 'part' } },
};

/** Values of an option, the usual one first, in a scene. */
const shows = (scene, values, shown = 'pieces', also = {}) => ({ scene, values, shown, also });

export const effects = {
  parts: shows('rabbit', [6, 2], 'sheet'),
  nets: 'It needs a file of Pepakura Designer, and no such file of our own making is at hand.',
  // Making room for flaps would hide most of the difference.
  solver: shows('heart', ['tree', 'genetic'], 'pieces', { compact: 'off' }),
  heuristic: shows('rabbit', ['steepest', 'flat'], 'sheet'),
  segment: shows('rabbit', ['merge', 'spectral'], 'sheet'),
  runs: shows('rabbit', [400, 10], 'sheet'),
  proxy:
    'It counts for models of more faces than N, and changes where borders of parts run by a little.',
  seed: shows('heart', [1, 2]),
  faces: shows('rabbit', [160, 80], 'sheet'),
  repair: 'It leaves faults of a file as they are; what is drawn here has none.',
  'fill-holes': shows('open box', ['off', 'all']),
  inside: shows('nested', ['keep', 'drop']),
  crossing: shows('crossed', ['keep', 'unite']),
  folding:
    'It decides whether a net without a folding motion is cut in two; most models have none.',
  clearance: 'It decides which folding motions count as free of collisions; sheets rarely change.',
  height: shows('box', [40, 25], 'sheet'),
  width: shows('box', [60, 40], 'sheet', { height: 'none' }),
  depth: shows('box', [30, 20], 'sheet', { height: 'none' }),
  up: shows('box', ['guess', 'z'], 'sheet'),
  scale: shows('box', [1, 0.6], 'sheet', { height: 'none', unit: 'mm' }),
  sheets: shows('heart', [1, 2], 'sheet', { height: 'none' }),
  unit: shows('box', ['mm', 'cm'], 'sheet', { height: 'none', scale: 0.1 }),
  paper: shows('box', ['A4', 'A5'], 'sheet', { height: 25 }),
  orientation: shows('box', ['auto', 'landscape'], 'sheet'),
  margin: shows('box', [10, 25], 'sheet', { height: 'none' }),
  flaps: shows('box', [5, 10, 'none']),
  'flap-angle': shows('box', [45, 20], corner),
  'flap-style': shows('drum', ['edge', 'run', 'zigzag'], rim),
  'flap-side': shows('box', ['one', 'both']),
  'flap-borders': shows('open box', ['off', 'on']),
  'glue-strips': shows('box', ['none', 'free'], 'sheet', { flaps: 'none' }),
  ids: shows('star', ['inside', 'flap', 'outside', 'none'], near),
  'min-piece': shows('stud', ['off', 10]),
  compact: shows('heart', ['on', 'off']),
  workers: 'It makes a run shorter and changes no file.',
  lang: shows('box', ['en', 'de'], 'foot'),
  'flat-fold': shows('drum', [3, 20], wall),
  style: shows('star', ['foldwright', 'pepakura', 'blender'], near),
  'cut-width': shows('box', ['style', 1], corner),
  'cut-colour': shows('box', ['style', '#c02020'], corner),
  'mountain-width': shows('box', ['style', 0.8], corner),
  'mountain-dash': shows('box', ['style', 'solid', '4,2'], corner),
  'mountain-colour': shows('box', ['style', '#008040'], corner),
  'valley-width': shows('star', ['style', 0.8], near),
  'valley-dash': shows('star', ['style', 'solid', '4,2'], near),
  'valley-colour': shows('star', ['style', '#008040'], near),
  'flap-colour': shows('box', ['style', '#ffe0a0', 'none'], corner),
  'fold-ticks': shows('star', ['off', 'on'], near),
  duplex:
    'It puts a page of fold lines behind each sheet of a PDF; other formats stay as they are.',
  'fold-angles': shows('star', ['off', 'on'], near),
  thickness: shows('box', ['off', 1.5], flap),
  legend: shows('box', ['on', 'off'], 'foot'),
  assembly: shows('rabbit', ['off', 'on'], 'sheet'),
  measured: shows('box', ['off', '49,50'], 'ruler'),
  machine: shows('box', ['none', 'silhouette', 'cricut'], 'head'),
  dpi: 'It is the number of dots of pictures; lines of SVG and PDF files have none.',
  texture: shows('house', ['on', 'off']),
  colour: shows('rabbit', ['none', 'part'], 'sheet', { texture: 'off' }),
  shading: shows('rabbit', ['off', 'on'], 'sheet', { texture: 'off' }),
  'flap-bleed': shows('painted', ['half', 'none', 'whole'], corner),
};
