/** English phrases for what is told of files: why one cannot be read, and what was mended or noticed in it. */
import { fillingFor } from '../../model/holes.js';
import type { Messages, Table } from '../messages.js';
import { choose, count, figure, rounded } from './numbers.js';

const quoted = (word: string): string => `'${word}'`;

/** "line 23: ", or nothing where no place is known. */
function prefix({ place, at }: { place?: string; at?: number }): string {
  return place === undefined || at === undefined ? '' : `${place} ${figure(at)}: `;
}

/** Where something is, after its sentence: " (line 23)", or of several where the first one is. */
function suffix(params: { place?: string; at?: number; count: number }): string {
  const place = prefix(params).slice(0, -2);
  if (place === '') return '';
  return params.count > 1 ? ` (the first: ${place})` : ` (${place})`;
}

const plural = {
  vertex: 'vertices',
  face: 'faces',
  edge: 'edges',
};

/** "1 face was turned over", "2 faces were turned over" */
function was(noun: keyof typeof plural, what: string): (params: { count: number }) => string {
  return ({ count: number }) =>
    `${count(number, noun, plural[noun])} ${choose(number, 'was', 'were')} ${what}`;
}

/** What the formats that are read are for people with a model of another one. */
const saveAs = 'save it as GLB, OBJ, STL, 3MF, PLY or OFF in the program that made it';
const readFormats = 'OBJ, STL, OFF, PLY, GLB, glTF, 3MF, PDO and FOLD are';

/** Endings of formats that are read, and whose contents say that they are. */
const readByContents: readonly string[] = ['glb', 'gltf', '3mf', 'pdo', 'zip'];

/** Models and projects of other programs, by the words of the engine or by the endings of their names. */
const models: Readonly<Record<string, string>> = {
  glb: 'a GLB (binary glTF) model',
  gltf: 'a glTF model',
  '3mf': 'a 3MF model',
  fbx: 'an FBX model',
  step: 'a STEP model',
  stp: 'a STEP model',
  iges: 'an IGES model',
  igs: 'an IGES model',
  blend: 'a Blender project',
  skp: 'a SketchUp model',
  '3dm': 'a Rhino model',
  vrml: 'a VRML model',
  wrl: 'a VRML model',
  vox: 'a MagicaVoxel model',
  draco: 'a Draco model',
  drc: 'a Draco model',
  dae: 'a COLLADA (DAE) model',
  x3d: 'an X3D model',
  amf: 'an AMF model',
  '3ds': 'a 3DS model',
  max: 'a 3ds Max project',
  c4d: 'a Cinema 4D project',
  ma: 'a Maya project',
  mb: 'a Maya project',
  lwo: 'a LightWave model',
  usd: 'a USD model',
  usda: 'a USD model',
  usdc: 'a USD model',
  usdz: 'a USDZ model',
  f3d: 'a Fusion project',
  sldprt: 'a SolidWorks part',
  scad: 'an OpenSCAD program',
  fcstd: 'a FreeCAD project',
};

/** Other files that people take for models. */
const others: Readonly<Record<string, string>> = {
  zstandard: 'a compressed Blender project or another Zstandard archive',
  dxf: 'a DXF drawing',
  dwg: 'a DWG drawing',
  pdf: 'a PDF document',
  ps: 'a PostScript document',
  png: 'a PNG picture',
  jpeg: 'a JPEG picture',
  gif: 'a GIF picture',
  gzip: 'a gzip archive',
  '7z': 'a 7-Zip archive',
  rar: 'a RAR archive',
  'git-lfs': 'a Git LFS pointer to a model',
  svg: 'an SVG drawing',
  html: 'a web page',
  xml: 'an XML document',
  json: 'a JSON document',
  zip: 'a ZIP archive',
};

function badHeader(params: Messages['bad-header']): string {
  switch (params.what) {
    case 'property-type':
      return `${prefix(params)}${quoted(params.word)} is not a property type`;
    case 'encoding':
      return `${prefix(params)}${quoted(params.word)} is not a PLY encoding`;
    case 'ply-magic':
      return `${prefix(params)}a PLY file begins with 'ply', this one with ${quoted(params.word)}`;
    case 'off-magic':
      return `${prefix(params)}an OFF file begins with OFF, this one with ${quoted(params.word)}`;
    case 'keyword':
      return `${prefix(params)}${quoted(params.word)} is not a header keyword`;
    case 'element-count':
      return `${prefix(params)}element ${quoted(params.element)} needs a count that is not negative`;
    case 'property-first':
      return `${prefix(params)}a property stands before any element`;
    case 'no-format':
      return `${prefix(params)}the header ends without a 'format' line`;
    case 'counts':
      return `${prefix(params)}the counts must not be negative`;
    case 'dimensions':
      return `the vertices have ${figure(params.dimensions)} dimensions; only models with 3 can be unfolded`;
    case 'property': {
      const list = params.property === 'vertex_indices' ? ' that is a list' : '';
      return `element ${quoted(params.element)} needs one property ${quoted(params.property)}${list}`;
    }
  }
}

function badIndex(params: Messages['bad-index']): string {
  const { index, vertices } = params;
  const face = `${prefix(params)}face refers to vertex ${figure(index)}`;
  if (params.what === 'before')
    return `${face}, but only ${figure(vertices)} vertices come before it`;
  const from = params.first === 0 ? ', counted from 0' : '';
  return `${face}, but the file has ${figure(vertices)} vertices${from}`;
}

function badNumber(params: Messages['bad-number']): string {
  const word = `${prefix(params)}${quoted(params.word)}`;
  if (params.what === 'comma') return `${word} has a comma where none is expected`;
  return `${word} stands where a ${params.what === 'whole' ? 'whole number' : 'number'} is expected`;
}

const noFaces = {
  nothing: 'the file has neither vertices nor faces',
  vertices: 'the file has vertices but no faces; points and lines alone cannot be unfolded',
  surfaces: "the file has free-form surfaces ('surf') but no faces; save it as polygons",
  model: 'the model has no faces',
} as const;

function truncated(params: Messages['truncated']): string {
  switch (params.what) {
    case 'number':
      return `${prefix(params)}the file ends where a number is expected`;
    case 'coordinates':
      return `${prefix(params)}vertex has fewer than 3 coordinates`;
    case 'corners':
      return `${prefix(params)}face has fewer corners than it announces`;
    case 'face':
      return `${prefix(params)}the file ends in the middle of a face`;
    case 'ply-header':
      return `${prefix(params)}the file ends before 'end_header'`;
    case 'more':
      return `${prefix(params)}the file ends here, but more is announced`;
    case 'stl-header':
      return `the file has ${figure(params.bytes)} bytes, too few for the header of a binary STL`;
    case 'triangles':
      return `${prefix(params)}the file ends here, but its header announces ${figure(params.announced)} triangles`;
    case 'element':
      return `${prefix(params)}the file ends here, but its header announces ${figure(params.announced)} of element ${quoted(params.element)}`;
    case 'keyword':
      return `${prefix(params)}the file ends where ${quoted(params.expected)} is expected`;
    case 'vertices':
    case 'faces':
      return `${prefix(params)}the file ends after ${figure(params.done)} of ${figure(params.announced)} ${params.what}`;
    case 'header-only':
      return `${prefix(params)}the file ends after its header`;
  }
}

/** What a file of a format that is not read is, and what to do: "is an FBX model, which is not read; save it ...". */
function unread(format: string): string {
  const model = models[format];
  if (model !== undefined) return `is ${model}, which is not read; ${saveAs}`;
  return `is ${others[format] ?? format}, which is not read; ${readFormats}`;
}

function unknownFormat(params: Messages['unknown-format']): string {
  switch (params.what) {
    case 'contents':
      return `the file ${unread(params.format)}`;
    case 'file':
      return `'${params.file}' ${unread(params.format)}`;
    case 'ending':
      // Readers see by its contents whether a file is theirs.
      if (readByContents.includes(params.ending)) {
        return `the file is named .${params.ending}, but does not begin like one: it is damaged, or of another kind; get it once more, or save it again`;
      }
      return params.ending in models
        ? `the file, by its ending, ${unread(params.ending)}`
        : `files that end in '.${params.ending}' are not read; ${readFormats}`;
    case 'nothing':
      return `neither the file's contents nor an ending of its name tell its format; ${readFormats}`;
  }
}

function ignoredElements({
  points,
  lines,
  curves,
  surfaces,
}: Messages['ignored-elements']): string {
  const kinds = [
    [points, 'point element'],
    [lines, 'line element'],
    [curves, 'free-form curve'],
    [surfaces, 'free-form surface'],
  ] as const;
  const found = kinds.filter(([number]) => number > 0);
  const list = found.map(([number, noun]) => count(number, noun)).join(', ');
  return `ignored, since only faces fold: ${list}`;
}

function openBorder(params: Messages['open-border']): string {
  if (params.what === 'edge') return 'only one face has this edge: there is nothing to join there';
  const edges = `${count(params.count, 'edge')} ${choose(params.count, 'lies', 'lie')}`;
  return (
    `${edges} on the border of ${count(params.bodies, 'open surface')} without a volume, printed as one layer of paper whose plain back can be seen; gaps wider than ${rounded(params.gap)} of the model's size, ` +
    'or wide against the edges beside them, are left open'
  );
}

function openHoles(params: Messages['open-holes']): string {
  const { count: number, percent, small, small_percent } = params;
  const widest = `${choose(number, '', 'the widest ')}${figure(percent)} % of the model's longest side across`;
  const all = `--fill-holes ${fillingFor(percent)} fills ${choose(number, 'it', 'them')}`;
  const few = `, --fill-holes ${small_percent} the ${choose(small, 'small one', `${figure(small)} small ones`)} alone`;
  return (
    `${count(number, 'hole')} ${choose(number, 'is', 'are')} left open, ${widest} ` +
    `(${all}${small > 0 && small < number ? few : ''})`
  );
}

export const fileMessages = {
  'bad-header': badHeader,
  'bad-index': badIndex,
  'bad-number': badNumber,
  'bad-size': ({ least, most }) =>
    `the model's size is out of range; ${least.toExponential()} to ${most.toExponential().replace('+', '')} is supported`,
  'bad-syntax': (params) =>
    `${prefix(params)}${quoted(params.word)} stands where ${quoted(params.expected)} is expected`,
  'bad-text': (params) => `${prefix(params)}a NUL byte stands in the text; the file is damaged`,
  'empty-file': () => 'the file is empty',
  'no-area': ({ what }) =>
    what === 'point'
      ? 'all vertices of the model lie at the same place'
      : 'no face of the model has an area',
  'no-faces': ({ what }) => noFaces[what],
  'not-finite': (params) =>
    params.what === 'weight'
      ? `${prefix(params)}the fourth coordinate of a vertex must not be 0`
      : `${prefix(params)}a coordinate is not a finite number`,
  'too-many-corners': ({ face, corners, most }) =>
    `face ${figure(face)} has ${figure(corners)} corners; up to ${figure(most)} are supported`,
  truncated,
  'unknown-format': unknownFormat,
  'no-model': ({ count: number }) =>
    `none of the ${figure(number)} files is a model that is read; ${readFormats}`,
  'several-models': ({ count: number, first, second }) =>
    number === 2
      ? `there are two models among the files: '${first}' and '${second}'; choose one of them`
      : `there are ${figure(number)} models among the files, among them '${first}' and '${second}'; choose one of them`,

  'closed-cracks': ({ count: number, width }) =>
    was(
      'edge',
      `joined to others across cracks, the widest ${rounded(width)} of the model's units wide`,
    )({
      count: number,
    }),
  'closed-t-junctions': was('edge', 'cut at vertices of its neighbours to close a crack'),
  'crossing-bodies': ({ count: number, unitable }) =>
    `${count(number, 'pair of bodies', 'pairs of bodies')} ${choose(number, 'runs', 'run')} through each other: ` +
    'their pieces would collide when assembled' +
    (unitable > 0
      ? ' (--crossing unite makes one of them)'
      : '; unite them in the modelling program'),
  'crossings-unchecked': ({ count: number }) =>
    `${count(number, 'face')} ${choose(number, 'is', 'are')} too many to look whether bodies run through each other or lie inside each other`,
  'counts-from-zero': () =>
    'the file counts its vertices from 0, not from 1 as its format does, and was read so',
  'cut-nonorientable': was('edge', 'cut open, since the surface has only one side'),
  'cut-off': (params) =>
    `${prefix(params)}the file ends too early; what stands before, ${count(params.count, 'face')}, is used`,
  'decimal-commas': ({ count: number }) =>
    `${count(number, 'number')} ${choose(number, 'has', 'have')} a comma and ${choose(number, 'was', 'were')} read as if it were a decimal point`,
  'dropped-degenerate-faces': was('face', 'dropped for having no area'),
  'dropped-duplicate-faces': was('face', 'dropped for repeating another one'),
  'dropped-inner-bodies': ({ count: number, faces }) =>
    `${count(number, 'body', 'bodies')} (${count(faces, 'face')}) ${choose(number, 'was', 'were')} left out, since nobody sees what lies inside another one`,
  'dropped-misnumbered-faces': (params) =>
    was('face', 'dropped for naming a vertex that the file does not have')(params) + suffix(params),
  'dropped-placeless-faces': (params) =>
    was('face', 'dropped for a vertex without usable coordinates')(params) +
    suffix({ ...params, count: 1 }),
  'dropped-unused-vertices': was('vertex', 'dropped, since no face uses it'),
  'filled-holes': ({ count: number }) =>
    `${count(number, 'hole')} ${choose(number, 'was', 'were')} filled with new faces, in the colours beside ${choose(number, 'it', 'them')}`,
  'flattened-faces': ({ count: number, distance }) =>
    was(
      'face',
      `made exactly flat, as drawn; no corner moved by more than ${rounded(distance)} of the model's units`,
    )({ count: number }),
  'flipped-faces': was('face', 'turned over, so that all have the same side outside'),
  'halved-edges': was('edge', 'halved, since two edges connected the same vertices'),
  'huge-holes': ({ count: number, edges }) =>
    `${count(number, 'hole')} ${choose(number, 'stays', 'stay')} open: only holes of at most ${figure(edges)} edges are filled`,
  'ignored-elements': ignoredElements,
  'inner-bodies': ({ count: number }) =>
    `${count(number, 'body lies', 'bodies lie')} inside another one, where nobody will see ${choose(number, 'it', 'them')} (--inside drop leaves ${choose(number, 'it', 'them')} out)`,
  'lost-picture-places': ({ count: number }) =>
    `${count(number, 'corner')} of faces name a place in the picture that the file does not have; these faces show their plain colour`,
  'merged-two-sided': was(
    'face',
    'given a second time from the other side; both sides are one skin of paper now',
  ),
  'missing-endsolid': () => "the file ends without 'endsolid'; triangles may be missing at its end",
  'not-united': ({ count: number, open }) =>
    `${count(number, 'body that runs', 'bodies that run')} through others could not be united with them` +
    (open === number
      ? ': only what is closed has an inside (--fill-holes all closes it)'
      : '; unite them in the modelling program'),
  'open-border': openBorder,
  'open-holes': openHoles,
  'other-format': ({ ending, format }) => `the file is named .${ending}, but holds ${format}`,
  'self-crossing-bodies': ({ count: number }) =>
    `${count(number, 'body', 'bodies')} ${choose(number, 'runs', 'run')} through itself: its pieces would collide ` +
    'when assembled; mend it in the modelling program',
  'split-nonmanifold-edges': ({ count: number }) =>
    `${count(number, 'edge')} with more than two faces came apart`,
  'split-nonmanifold-vertices': ({ count: number }) =>
    `${count(number, 'vertex', 'vertices')} where surfaces only touch came apart`,
  'trailing-bytes': ({ count: number }) =>
    `${figure(number)} bytes after the last triangle were ignored`,
  'trailing-lines': ({ count: number }) =>
    `${count(number, 'line')} after the last face ${choose(number, 'was', 'were')} ignored`,
  'triangulated-polygons': ({ count: number }) =>
    `${count(number, 'face')} with more than three corners ${choose(number, 'was', 'were')} cut into triangles`,
  'unfilled-holes': ({ count: number }) =>
    `${count(number, 'hole')} ${choose(number, 'stays', 'stay')} open: every face in ${choose(number, 'it', 'them')} would run through the model or lie on it`,
  'united-bodies': ({ count: number, faces }) =>
    `${count(number, 'body', 'bodies')} that ran through each other were united` +
    (faces > 0 ? `; nothing is left of ${count(faces, 'face')} inside` : ''),
  'welded-vertices': was('vertex', 'merged with others at the same place'),
  'wrong-count': ({ count: number, announced }) =>
    `the header announces ${figure(announced)} triangles, but the file has ${figure(number)}, which were all read`,
} satisfies Partial<Table>;
