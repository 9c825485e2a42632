/** French phrases for what is told of files: why one cannot be read, and what was mended or noticed in it. */
import { fillingFor } from '../../model/holes.js';
import type { Messages, Table } from '../messages.js';
import { count, figure, rounded } from './numbers.js';

const quoted = (word: string): string => `'${word}'`;

const places: Readonly<Record<string, string>> = {
  line: 'ligne',
  vertex: 'sommet',
  face: 'face',
  element: 'élément',
  triangle: 'triangle',
  count: 'nombre',
};

/** "ligne 23", or nothing where no place is known. */
function placeOf({ place, at }: { place?: string; at?: number }): string {
  return place === undefined || at === undefined ? '' : `${places[place] ?? place} ${figure(at)}`;
}

/** "ligne 23 : ", or nothing where no place is known. */
function prefix(params: { place?: string; at?: number }): string {
  const place = placeOf(params);
  return place === '' ? '' : `${place}\u202f: `;
}

/** Where something is, after its sentence: " (ligne 23)", or of several where the first one is. */
function suffix(params: { place?: string; at?: number; count: number }): string {
  const place = placeOf(params);
  if (place === '') return '';
  return params.count > 1 ? ` (la première\u202f: ${place})` : ` (${place})`;
}

/** "1 face a été retournée", "2 faces ont été retournées": `one` and `many` are what follows the number. */
function counted(one: string, many: string): (params: { count: number }) => string {
  return ({ count: number }) => count(number, one, many);
}

const saveAs = 'enregistre-le en GLB, OBJ, STL, 3MF, PLY ou OFF dans le programme qui l’a fait';
const readFormats = 'les formats lus sont OBJ, STL, OFF, PLY, GLB, glTF, 3MF, PDO et FOLD';

/** Endings of formats that are read, and whose contents say that they are. */
const readByContents: readonly string[] = ['glb', 'gltf', '3mf', 'pdo', 'zip'];

/** Models and projects of other programs, by the words of the engine or by the endings of their names. */
const models: Readonly<Record<string, string>> = {
  glb: 'un modèle GLB (glTF binaire)',
  gltf: 'un modèle glTF',
  '3mf': 'un modèle 3MF',
  fbx: 'un modèle FBX',
  step: 'un modèle STEP',
  stp: 'un modèle STEP',
  iges: 'un modèle IGES',
  igs: 'un modèle IGES',
  blend: 'un projet Blender',
  skp: 'un modèle SketchUp',
  '3dm': 'un modèle Rhino',
  vrml: 'un modèle VRML',
  wrl: 'un modèle VRML',
  vox: 'un modèle MagicaVoxel',
  draco: 'un modèle Draco',
  drc: 'un modèle Draco',
  dae: 'un modèle COLLADA (DAE)',
  x3d: 'un modèle X3D',
  amf: 'un modèle AMF',
  '3ds': 'un modèle 3DS',
  max: 'un projet 3ds Max',
  c4d: 'un projet Cinema 4D',
  ma: 'un projet Maya',
  mb: 'un projet Maya',
  lwo: 'un modèle LightWave',
  usd: 'un modèle USD',
  usda: 'un modèle USD',
  usdc: 'un modèle USD',
  usdz: 'un modèle USDZ',
  f3d: 'un projet Fusion',
  sldprt: 'une pièce SolidWorks',
  scad: 'un programme OpenSCAD',
  fcstd: 'un projet FreeCAD',
};

/** Other files that people take for models. */
const others: Readonly<Record<string, string>> = {
  zstandard: 'un projet Blender compressé ou une autre archive Zstandard',
  dxf: 'un dessin DXF',
  dwg: 'un dessin DWG',
  pdf: 'un document PDF',
  ps: 'un document PostScript',
  png: 'une image PNG',
  jpeg: 'une image JPEG',
  gif: 'une image GIF',
  gzip: 'une archive gzip',
  '7z': 'une archive 7-Zip',
  rar: 'une archive RAR',
  'git-lfs': 'un renvoi Git LFS vers un modèle',
  svg: 'un dessin SVG',
  html: 'une page web',
  xml: 'un document XML',
  json: 'un document JSON',
  zip: 'une archive ZIP',
};

function badHeader(params: Messages['bad-header']): string {
  switch (params.what) {
    case 'property-type':
      return `${prefix(params)}${quoted(params.word)} n’est pas un type de propriété`;
    case 'encoding':
      return `${prefix(params)}${quoted(params.word)} n’est pas un codage PLY`;
    case 'ply-magic':
      return `${prefix(params)}un fichier PLY commence par 'ply', celui-ci par ${quoted(params.word)}`;
    case 'off-magic':
      return `${prefix(params)}un fichier OFF commence par OFF, celui-ci par ${quoted(params.word)}`;
    case 'keyword':
      return `${prefix(params)}${quoted(params.word)} n’est pas un mot connu de l’en-tête`;
    case 'element-count':
      return `${prefix(params)}l’élément ${quoted(params.element)} a besoin d’un nombre qui ne soit pas négatif`;
    case 'property-first':
      return `${prefix(params)}une propriété est placée avant tout élément`;
    case 'no-format':
      return `${prefix(params)}l’en-tête se termine sans ligne 'format'`;
    case 'counts':
      return `${prefix(params)}les nombres ne doivent pas être négatifs`;
    case 'dimensions':
      return `les sommets ont ${count(params.dimensions, 'dimension', 'dimensions')}\u202f; seuls les modèles qui en ont 3 peuvent être dépliés`;
    case 'property': {
      const list = params.property === 'vertex_indices' ? ' qui soit une liste' : '';
      return `l’élément ${quoted(params.element)} a besoin d’une propriété ${quoted(params.property)}${list}`;
    }
  }
}

function badIndex(params: Messages['bad-index']): string {
  const { index, vertices } = params;
  const face = `${prefix(params)}une face renvoie au sommet ${figure(index)}`;
  if (params.what === 'before') {
    return `${face}, mais il n’y a que ${count(vertices, 'sommet', 'sommets')} avant`;
  }
  const from = params.first === 0 ? ', comptés à partir de 0' : '';
  return `${face}, mais le fichier a ${count(vertices, 'sommet', 'sommets')}${from}`;
}

function badNumber(params: Messages['bad-number']): string {
  const word = `${prefix(params)}${quoted(params.word)}`;
  if (params.what === 'comma') return `${word} a une virgule là où il n’en faut pas`;
  return `${word} se trouve là où un ${params.what === 'whole' ? 'nombre entier' : 'nombre'} est attendu`;
}

const noFaces = {
  nothing: 'le fichier n’a ni sommets ni faces',
  vertices:
    'le fichier a des sommets mais pas de faces\u202f; des points et des lignes seuls ne peuvent pas être dépliés',
  surfaces:
    "le fichier a des surfaces de forme libre ('surf') mais pas de faces\u202f; enregistre-le en polygones",
  model: 'le modèle n’a pas de faces',
} as const;

function truncated(params: Messages['truncated']): string {
  switch (params.what) {
    case 'number':
      return `${prefix(params)}le fichier se termine là où un nombre est attendu`;
    case 'coordinates':
      return `${prefix(params)}le sommet a moins de 3 coordonnées`;
    case 'corners':
      return `${prefix(params)}la face a moins de sommets qu’elle n’en annonce`;
    case 'face':
      return `${prefix(params)}le fichier se termine au milieu d’une face`;
    case 'ply-header':
      return `${prefix(params)}le fichier se termine avant 'end_header'`;
    case 'more':
      return `${prefix(params)}le fichier se termine ici, alors qu’il annonce une suite`;
    case 'stl-header':
      return `le fichier a ${count(params.bytes, 'octet', 'octets')}, trop peu pour l’en-tête d’un STL binaire`;
    case 'triangles':
      return `${prefix(params)}le fichier se termine ici, mais son en-tête annonce ${count(params.announced, 'triangle', 'triangles')}`;
    case 'element':
      return `${prefix(params)}le fichier se termine ici, mais son en-tête annonce ${figure(params.announced)} fois l’élément ${quoted(params.element)}`;
    case 'keyword':
      return `${prefix(params)}le fichier se termine là où ${quoted(params.expected)} est attendu`;
    case 'vertices':
    case 'faces': {
      const [one, many] =
        params.what === 'faces' ? (['face', 'faces'] as const) : (['sommet', 'sommets'] as const);
      return `${prefix(params)}le fichier se termine après ${count(params.done, one, many)} sur ${figure(params.announced)}`;
    }
    case 'header-only':
      return `${prefix(params)}le fichier se termine après son en-tête`;
  }
}

/** What a file of a format that is not read is, and what to do. */
function unread(format: string): string {
  const model = models[format];
  if (model !== undefined) return `est ${model}, un format qui n’est pas lu\u202f; ${saveAs}`;
  return `est ${others[format] ?? format}, un format qui n’est pas lu\u202f; ${readFormats}`;
}

function unknownFormat(params: Messages['unknown-format']): string {
  switch (params.what) {
    case 'contents':
      return `le fichier ${unread(params.format)}`;
    case 'file':
      return `'${params.file}' ${unread(params.format)}`;
    case 'ending':
      // Readers see by its contents whether a file is theirs.
      if (readByContents.includes(params.ending)) {
        return `le fichier s’appelle .${params.ending}, mais ne commence pas ainsi\u202f: il est abîmé, ou d’un autre genre\u202f; récupère-le encore une fois, ou enregistre-le à nouveau`;
      }
      return params.ending in models
        ? `le fichier, d’après sa terminaison, ${unread(params.ending)}`
        : `les fichiers qui se terminent par '.${params.ending}' ne sont pas lus\u202f; ${readFormats}`;
    case 'nothing':
      return `ni le contenu du fichier ni la fin de son nom ne disent son format\u202f; ${readFormats}`;
  }
}

function ignoredElements(params: Messages['ignored-elements']): string {
  const { points, lines, curves, surfaces } = params;
  const kinds = [
    [points, 'point', 'points'],
    [lines, 'ligne', 'lignes'],
    [curves, 'courbe de forme libre', 'courbes de forme libre'],
    [surfaces, 'surface de forme libre', 'surfaces de forme libre'],
  ] as const;
  const found = kinds.filter(([number]) => number > 0);
  const list = found.map(([number, one, many]) => count(number, one, many)).join(', ');
  return `non utilisé, car seules les faces se plient\u202f: ${list}`;
}

function openBorder(params: Messages['open-border']): string {
  if (params.what === 'edge') {
    return 'une seule face a cette arête\u202f: il n’y a rien à joindre là';
  }
  return (
    `${count(params.count, 'arête est', 'arêtes sont')} au bord de ${count(params.bodies, 'surface ouverte', 'surfaces ouvertes')} sans volume, imprimées comme une couche de papier dont le dos vierge se voit\u202f; les fentes plus larges que ${rounded(params.gap)} fois la taille du modèle, ` +
    'ou larges par rapport aux arêtes voisines, restent ouvertes'
  );
}

function openHoles(params: Messages['open-holes']): string {
  const { count: number, percent, small, small_percent } = params;
  const open = count(
    number,
    'trou reste ouvert et mesure',
    'trous restent ouverts et le plus large mesure',
  );
  const all = `--fill-holes ${fillingFor(percent)} ${number > 1 ? 'les' : 'le'} bouche`;
  const few = `, --fill-holes ${small_percent} seulement ${small > 1 ? `les ${figure(small)} petits` : 'le petit'}`;
  return (
    `${open} ${figure(percent)}\u202f% du plus long côté du modèle ` +
    `(${all}${small > 0 && small < number ? few : ''})`
  );
}

export const fileMessages = {
  'bad-header': badHeader,
  'bad-index': badIndex,
  'bad-number': badNumber,
  'bad-size': ({ least, most }) =>
    `la taille du modèle sort des limites, qui vont de ${least.toExponential()} à ${most.toExponential().replace('+', '')}`,
  'bad-syntax': (params) =>
    `${prefix(params)}${quoted(params.word)} se trouve là où ${quoted(params.expected)} est attendu`,
  'bad-text': (params) =>
    `${prefix(params)}il y a un octet NUL dans le texte\u202f; le fichier est abîmé`,
  'empty-file': () => 'le fichier est vide',
  'no-area': ({ what }) =>
    what === 'point'
      ? 'tous les sommets du modèle sont au même endroit'
      : 'aucune face du modèle n’a de surface',
  'no-faces': ({ what }) => noFaces[what],
  'not-finite': (params) =>
    params.what === 'weight'
      ? `${prefix(params)}la quatrième coordonnée d’un sommet ne doit pas être 0`
      : `${prefix(params)}une coordonnée n’est pas un nombre fini`,
  'too-many-corners': ({ face, corners, most }) =>
    `la face ${figure(face)} a ${count(corners, 'coin', 'coins')}\u202f; le maximum est ${figure(most)}`,
  truncated,
  'unknown-format': unknownFormat,
  'no-model': ({ count: number }) =>
    number === 1
      ? `le fichier n’est pas un modèle qui peut être lu\u202f; ${readFormats}`
      : `aucun des ${figure(number)} fichiers n’est un modèle qui peut être lu\u202f; ${readFormats}`,
  'several-models': ({ count: number, first, second }) =>
    number === 2
      ? `il y a deux modèles parmi les fichiers\u202f: '${first}' et '${second}'\u202f; choisis l’un d’eux`
      : `il y a ${figure(number)} modèles parmi les fichiers, dont '${first}' et '${second}'\u202f; choisis l’un d’eux`,

  'closed-cracks': ({ count: number, width }) =>
    `${count(number, 'arête a été jointe', 'arêtes ont été jointes')} à d’autres par-dessus des fissures, ` +
    `dont la plus large mesure ${rounded(width)} en unités du modèle`,
  'closed-t-junctions': counted(
    'arête a été divisée aux sommets de ses voisines pour fermer une fissure',
    'arêtes ont été divisées aux sommets de leurs voisines pour fermer une fissure',
  ),
  'crossing-bodies': ({ count: number, unitable }) =>
    `${count(number, 'paire de corps se traverse', 'paires de corps se traversent')}\u202f: ` +
    'leurs pièces se heurteraient au montage' +
    (unitable > 0
      ? ' (--crossing unite les réunit)'
      : '\u202f; réunis-les dans le programme de modélisation'),
  'crossings-unchecked': ({ count: number }) =>
    `${count(number, 'face', 'faces')}, c’est trop pour vérifier si des corps se traversent ou sont l’un dans l’autre`,
  'counts-from-zero': () =>
    'le fichier compte ses sommets à partir de 0, et non de 1 comme le veut son format, et a été lu ainsi',
  'cut-nonorientable': counted(
    'arête a été ouverte, car la surface n’a qu’un seul côté',
    'arêtes ont été ouvertes, car la surface n’a qu’un seul côté',
  ),
  'cut-off': (params) =>
    `${prefix(params)}le fichier se termine trop tôt\u202f; ce qui vient avant, ${count(params.count, 'face', 'faces')}, est utilisé`,
  'decimal-commas': ({ count: number }) =>
    `${count(number, 'nombre a une virgule et a été lu', 'nombres ont une virgule et ont été lus')} comme si c’était un point décimal`,
  'dropped-degenerate-faces': counted(
    'face a été enlevée, car elle n’a pas de surface',
    'faces ont été enlevées, car elles n’ont pas de surface',
  ),
  'dropped-duplicate-faces': counted(
    'face a été enlevée, car elle en répète une autre',
    'faces ont été enlevées, car elles en répètent d’autres',
  ),
  'dropped-inner-bodies': ({ count: number, faces }) =>
    `${count(number, 'corps', 'corps')} (${count(faces, 'face', 'faces')}) ${number > 1 ? 'ont été laissés' : 'a été laissé'} de côté, car personne ne voit ce qui est à l’intérieur d’un autre`,
  'dropped-misnumbered-faces': (params) =>
    counted(
      'face a été enlevée, car elle nomme un sommet que le fichier n’a pas',
      'faces ont été enlevées, car elles nomment un sommet que le fichier n’a pas',
    )(params) + suffix(params),
  'dropped-placeless-faces': (params) =>
    counted(
      'face a été enlevée à cause d’un sommet sans coordonnées utilisables',
      'faces ont été enlevées à cause d’un sommet sans coordonnées utilisables',
    )(params) + suffix({ ...params, count: 1 }),
  'dropped-unused-vertices': counted(
    'sommet a été enlevé, car aucune face ne l’utilise',
    'sommets ont été enlevés, car aucune face ne les utilise',
  ),
  'filled-holes': counted(
    'trou a été bouché avec de nouvelles faces, aux couleurs d’à côté',
    'trous ont été bouchés avec de nouvelles faces, aux couleurs d’à côté',
  ),
  'flattened-faces': ({ count: number, distance }) =>
    `${count(number, 'face a été rendue exactement plane, comme elle est dessinée', 'faces ont été rendues exactement planes, comme elles sont dessinées')}\u202f; ` +
    `aucun coin n’a bougé de plus de ${rounded(distance)} en unités du modèle`,
  'flipped-faces': counted(
    'face a été retournée, pour que toutes aient le même côté à l’extérieur',
    'faces ont été retournées, pour que toutes aient le même côté à l’extérieur',
  ),
  'halved-edges': counted(
    'arête a été coupée en deux, car deux arêtes reliaient les mêmes sommets',
    'arêtes ont été coupées en deux, car deux arêtes reliaient les mêmes sommets',
  ),
  'huge-holes': ({ count, edges }) =>
    counted(
      'trou reste ouvert\u202f: seuls les trous d’au plus',
      'trous restent ouverts\u202f: seuls les trous d’au plus',
    )({ count }) + ` ${figure(edges)} arêtes sont comblés`,
  'ignored-elements': ignoredElements,
  'inner-bodies': counted(
    'corps est à l’intérieur d’un autre, où personne ne le verra (--inside drop le laisse de côté)',
    'corps sont à l’intérieur d’un autre, où personne ne les verra (--inside drop les laisse de côté)',
  ),
  'lost-picture-places': ({ count: number }) =>
    `${count(number, 'coin de face nomme', 'coins de faces nomment')} un endroit de l’image que le fichier n’a pas\u202f; ces faces montrent leur couleur unie`,
  'merged-two-sided': counted(
    'face a été donnée une deuxième fois depuis l’autre côté\u202f; les deux côtés sont maintenant une seule peau de papier',
    'faces ont été données une deuxième fois depuis l’autre côté\u202f; les deux côtés sont maintenant une seule peau de papier',
  ),
  'missing-endsolid': () =>
    "le fichier se termine sans 'endsolid'\u202f; il peut manquer des triangles à la fin",
  'not-united': ({ count: number, open }) =>
    `${count(number, 'corps qui en traverse d’autres n’a pas pu être réuni', 'corps qui en traversent d’autres n’ont pas pu être réunis')} avec eux` +
    (open === number
      ? '\u202f: seul ce qui est fermé a un intérieur (--fill-holes all le ferme)'
      : '\u202f; réunis-les dans le programme de modélisation'),
  'open-border': openBorder,
  'open-holes': openHoles,
  'other-format': ({ ending, format }) =>
    `le fichier s’appelle .${ending}, mais son contenu est ${format}`,
  'self-crossing-bodies': ({ count: number }) =>
    `${count(number, 'corps se traverse lui-même\u202f: ses', 'corps se traversent eux-mêmes\u202f: leurs')} pièces se heurteraient ` +
    'au montage\u202f; corrige cela dans le programme de modélisation',
  'split-nonmanifold-edges': counted(
    'arête avec plus de deux faces a été séparée',
    'arêtes avec plus de deux faces ont été séparées',
  ),
  'split-nonmanifold-vertices': counted(
    'sommet où des surfaces ne font que se toucher a été séparé',
    'sommets où des surfaces ne font que se toucher ont été séparés',
  ),
  'trailing-bytes': counted(
    'octet après le dernier triangle a été ignoré',
    'octets après le dernier triangle ont été ignorés',
  ),
  'trailing-lines': counted(
    'ligne après la dernière face a été ignorée',
    'lignes après la dernière face ont été ignorées',
  ),
  'triangulated-polygons': counted(
    'face avec plus de trois coins a été coupée en triangles',
    'faces avec plus de trois coins ont été coupées en triangles',
  ),
  'unfilled-holes': counted(
    'trou reste ouvert\u202f: toute face y traverserait le modèle ou se poserait dessus',
    'trous restent ouverts\u202f: toute face y traverserait le modèle ou se poserait dessus',
  ),
  'united-bodies': ({ count: number, faces }) =>
    `${count(number, 'corps qui en traversait un autre a été réuni', 'corps qui se traversaient ont été réunis')}` +
    (faces > 0 ? `\u202f; il ne reste rien de ${count(faces, 'face', 'faces')} à l’intérieur` : ''),
  'welded-vertices': counted(
    'sommet a été fusionné avec d’autres au même endroit',
    'sommets ont été fusionnés avec d’autres au même endroit',
  ),
  'wrong-count': ({ count: number, announced }) =>
    `l’en-tête annonce ${count(announced, 'triangle', 'triangles')}, mais le fichier en a ${figure(number)}, qui ont tous été lus`,
} satisfies Partial<Table>;
