/** Spanish phrases for what is told of files: why one cannot be read, and what was mended or noticed in it. */
import { fillingFor } from '../../model/holes.js';
import type { Messages, Table } from '../messages.js';
import { choose, count, counted, figure, rounded } from './numbers.js';

const quoted = (word: string): string => `'${word}'`;

const places: Readonly<Record<string, string>> = {
  line: 'línea',
  vertex: 'vértice',
  face: 'cara',
  element: 'elemento',
  triangle: 'triángulo',
  count: 'número',
};

/** "línea 23: ", or nothing where no place is known. */
function prefix({ place, at }: { place?: string; at?: number }): string {
  return place === undefined || at === undefined ? '' : `${places[place] ?? place} ${figure(at)}: `;
}

/** Where something is, after its sentence: " (línea 23)", or of several where the first one is. */
function suffix(params: { place?: string; at?: number; count: number }): string {
  const place = prefix(params).slice(0, -2);
  if (place === '') return '';
  return params.count > 1 ? ` (la primera: ${place})` : ` (${place})`;
}

const plural = { vértice: 'vértices', cara: 'caras', arista: 'aristas' } as const;

/** "1 cara se giró para ...", "2 caras se giraron para ..." */
function told(
  noun: keyof typeof plural,
  [one, many]: readonly [string, string],
  rest: string,
): (params: { count: number }) => string {
  return ({ count: number }) =>
    `${count(number, noun, plural[noun])} ${choose(number, one, many)} ${rest}`;
}

const dropped = ['se descartó', 'se descartaron'] as const;

/** What the formats that are read are for people with a model of another one. */
const saveAs = 'guárdalo como GLB, OBJ, STL, 3MF, PLY u OFF en el programa con el que se hizo';
const readFormats = 'se leen OBJ, STL, OFF, PLY, GLB, glTF, 3MF, PDO y FOLD';

/** Endings of formats that are read, and whose contents say that they are. */
const readByContents: readonly string[] = ['glb', 'gltf', '3mf', 'pdo', 'zip'];

/** Models and projects of other programs, by the words of the engine or by the endings of their names. */
const models: Readonly<Record<string, string>> = {
  glb: 'un modelo GLB (glTF binario)',
  gltf: 'un modelo glTF',
  '3mf': 'un modelo 3MF',
  fbx: 'un modelo FBX',
  step: 'un modelo STEP',
  stp: 'un modelo STEP',
  iges: 'un modelo IGES',
  igs: 'un modelo IGES',
  blend: 'un proyecto de Blender',
  skp: 'un modelo de SketchUp',
  '3dm': 'un modelo de Rhino',
  vrml: 'un modelo VRML',
  wrl: 'un modelo VRML',
  vox: 'un modelo de MagicaVoxel',
  draco: 'un modelo Draco',
  drc: 'un modelo Draco',
  dae: 'un modelo COLLADA (DAE)',
  x3d: 'un modelo X3D',
  amf: 'un modelo AMF',
  '3ds': 'un modelo 3DS',
  max: 'un proyecto de 3ds Max',
  c4d: 'un proyecto de Cinema 4D',
  ma: 'un proyecto de Maya',
  mb: 'un proyecto de Maya',
  lwo: 'un modelo de LightWave',
  usd: 'un modelo USD',
  usda: 'un modelo USD',
  usdc: 'un modelo USD',
  usdz: 'un modelo USDZ',
  f3d: 'un proyecto de Fusion',
  sldprt: 'una pieza de SolidWorks',
  scad: 'un programa de OpenSCAD',
  fcstd: 'un proyecto de FreeCAD',
};

/** Other files that people take for models. */
const others: Readonly<Record<string, string>> = {
  zstandard: 'un proyecto de Blender comprimido u otro archivo Zstandard',
  dxf: 'un dibujo DXF',
  dwg: 'un dibujo DWG',
  pdf: 'un documento PDF',
  ps: 'un documento PostScript',
  png: 'una imagen PNG',
  jpeg: 'una imagen JPEG',
  gif: 'una imagen GIF',
  gzip: 'un archivo gzip',
  '7z': 'un archivo 7-Zip',
  rar: 'un archivo RAR',
  'git-lfs': 'un puntero de Git LFS a un modelo',
  svg: 'un dibujo SVG',
  html: 'una página web',
  xml: 'un documento XML',
  json: 'un documento JSON',
  zip: 'un archivo ZIP',
};

function badHeader(params: Messages['bad-header']): string {
  switch (params.what) {
    case 'property-type':
      return `${prefix(params)}${quoted(params.word)} no es un tipo de propiedad`;
    case 'encoding':
      return `${prefix(params)}${quoted(params.word)} no es una codificación PLY`;
    case 'ply-magic':
      return `${prefix(params)}un archivo PLY empieza por 'ply', y este por ${quoted(params.word)}`;
    case 'off-magic':
      return `${prefix(params)}un archivo OFF empieza por OFF, y este por ${quoted(params.word)}`;
    case 'keyword':
      return `${prefix(params)}${quoted(params.word)} no es una palabra de la cabecera`;
    case 'element-count':
      return `${prefix(params)}el elemento ${quoted(params.element)} necesita un número que no sea negativo`;
    case 'property-first':
      return `${prefix(params)}hay una propiedad antes del primer elemento`;
    case 'no-format':
      return `${prefix(params)}la cabecera termina sin una línea 'format'`;
    case 'counts':
      return `${prefix(params)}los números no deben ser negativos`;
    case 'dimensions':
      return `los vértices tienen ${figure(params.dimensions)} dimensiones; solo se pueden desplegar modelos con 3`;
    case 'property': {
      const list = params.property === 'vertex_indices' ? ' que sea una lista' : '';
      return `el elemento ${quoted(params.element)} necesita una propiedad ${quoted(params.property)}${list}`;
    }
  }
}

function badIndex(params: Messages['bad-index']): string {
  const { index, vertices } = params;
  const face = `${prefix(params)}una cara nombra el vértice ${figure(index)}`;
  const known = count(vertices, 'vértice', 'vértices');
  if (params.what === 'before') return `${face}, pero antes solo hay ${known}`;
  const from = params.first === 0 ? ', contando desde 0' : '';
  return `${face}, pero el archivo tiene ${known}${from}`;
}

function badNumber(params: Messages['bad-number']): string {
  const word = `${prefix(params)}${quoted(params.word)}`;
  if (params.what === 'comma') return `${word} tiene una coma donde no se espera`;
  return `${word} está donde se espera un ${params.what === 'whole' ? 'número entero' : 'número'}`;
}

const noFaces = {
  nothing: 'el archivo no tiene ni vértices ni caras',
  vertices:
    'el archivo tiene vértices pero no caras; los puntos y las líneas solos no se pueden desplegar',
  surfaces:
    "el archivo tiene superficies de forma libre ('surf') pero no caras; guárdalo como polígonos",
  model: 'el modelo no tiene caras',
} as const;

function truncated(params: Messages['truncated']): string {
  switch (params.what) {
    case 'number':
      return `${prefix(params)}el archivo termina donde se espera un número`;
    case 'coordinates':
      return `${prefix(params)}el vértice tiene menos de 3 coordenadas`;
    case 'corners':
      return `${prefix(params)}la cara tiene menos vértices de los que anuncia`;
    case 'face':
      return `${prefix(params)}el archivo termina en medio de una cara`;
    case 'ply-header':
      return `${prefix(params)}el archivo termina antes de 'end_header'`;
    case 'more':
      return `${prefix(params)}el archivo termina aquí, pero anuncia más`;
    case 'stl-header':
      return `el archivo tiene ${figure(params.bytes)} bytes, demasiado pocos para la cabecera de un STL binario`;
    case 'triangles':
      return `${prefix(params)}el archivo termina aquí, pero su cabecera anuncia ${counted.triangles(params.announced)}`;
    case 'element':
      return `${prefix(params)}el archivo termina aquí, pero su cabecera anuncia ${figure(params.announced)} del elemento ${quoted(params.element)}`;
    case 'keyword':
      return `${prefix(params)}el archivo termina donde se espera ${quoted(params.expected)}`;
    case 'vertices':
    case 'faces': {
      const noun = params.what === 'faces' ? 'caras' : 'vértices';
      return `${prefix(params)}el archivo termina después de ${figure(params.done)} de ${figure(params.announced)} ${noun}`;
    }
    case 'header-only':
      return `${prefix(params)}el archivo termina después de su cabecera`;
  }
}

/** What a file of a format that is not read is, and what to do: "es un modelo FBX, que aquí no se lee; guárdalo ...". */
function unread(format: string): string {
  const model = models[format];
  if (model !== undefined) return `es ${model}, que aquí no se lee; ${saveAs}`;
  return `es ${others[format] ?? format}, que aquí no se lee; ${readFormats}`;
}

function unknownFormat(params: Messages['unknown-format']): string {
  switch (params.what) {
    case 'contents':
      return `el archivo ${unread(params.format)}`;
    case 'file':
      return `'${params.file}' ${unread(params.format)}`;
    case 'ending':
      // Readers see by its contents whether a file is theirs.
      if (readByContents.includes(params.ending)) {
        return `el archivo se llama .${params.ending}, pero no empieza como tal: está dañado o es de otro tipo; consíguelo otra vez o guárdalo de nuevo`;
      }
      return params.ending in models
        ? `el archivo, por su extensión, ${unread(params.ending)}`
        : `los archivos que acaban en '.${params.ending}' no se leen; ${readFormats}`;
    case 'nothing':
      return `ni el contenido del archivo ni la extensión de su nombre dicen su formato; ${readFormats}`;
  }
}

function ignoredElements(params: Messages['ignored-elements']): string {
  const { points, lines, curves, surfaces } = params;
  const kinds = [
    [points, 'punto', 'puntos'],
    [lines, 'línea', 'líneas'],
    [curves, 'curva de forma libre', 'curvas de forma libre'],
    [surfaces, 'superficie de forma libre', 'superficies de forma libre'],
  ] as const;
  const found = kinds.filter(([number]) => number > 0);
  const list = found.map(([number, one, many]) => count(number, one, many)).join(', ');
  return `no se usa, porque solo se pliegan las caras: ${list}`;
}

function openBorder(params: Messages['open-border']): string {
  if (params.what === 'edge') {
    return 'solo una cara tiene esta arista: ahí no hay nada que unir';
  }
  return (
    `${count(params.count, 'arista está', 'aristas están')} en el borde de ${count(params.bodies, 'superficie abierta', 'superficies abiertas')} sin volumen, que se imprimen como una capa de papel con el dorso en blanco a la vista; los huecos de más de ` +
    `${rounded(params.gap)} del tamaño del modelo, o anchos para las aristas de al lado, se quedan abiertos`
  );
}

function openHoles(params: Messages['open-holes']): string {
  const { count: number, percent, small, small_percent } = params;
  const open = choose(number, 'se queda abierto y mide', 'se quedan abiertos y el más ancho mide');
  const all = `--fill-holes ${fillingFor(percent)} ${choose(number, 'lo', 'los')} rellena`;
  const few = `; --fill-holes ${small_percent}, solo ${choose(small, 'el pequeño', `los ${figure(small)} pequeños`)}`;
  return (
    `${count(number, 'agujero', 'agujeros')} ${open} el ${figure(percent)} % del lado más largo del modelo ` +
    `(${all}${small > 0 && small < number ? few : ''})`
  );
}

export const fileMessages = {
  'bad-header': badHeader,
  'bad-index': badIndex,
  'bad-number': badNumber,
  'bad-size': ({ least, most }) =>
    `el tamaño del modelo se sale de lo posible; vale de ${least.toExponential()} a ${most.toExponential().replace('+', '')}`,
  'bad-syntax': (params) =>
    `${prefix(params)}${quoted(params.word)} está donde se espera ${quoted(params.expected)}`,
  'bad-text': (params) => `${prefix(params)}hay un byte NUL en el texto; el archivo está dañado`,
  'empty-file': () => 'el archivo está vacío',
  'no-area': ({ what }) =>
    what === 'point'
      ? 'todos los vértices del modelo están en el mismo sitio'
      : 'ninguna cara del modelo tiene área',
  'no-faces': ({ what }) => noFaces[what],
  'not-finite': (params) =>
    params.what === 'weight'
      ? `${prefix(params)}la cuarta coordenada de un vértice no puede ser 0`
      : `${prefix(params)}una coordenada no es un número finito`,
  'too-many-corners': ({ face, corners, most }) =>
    `la cara ${figure(face)} tiene ${figure(corners)} esquinas; se admiten hasta ${figure(most)}`,
  truncated,
  'unknown-format': unknownFormat,
  'no-model': ({ count: number }) =>
    `ninguno de los ${figure(number)} archivos es un modelo que se lea; ${readFormats}`,
  'several-models': ({ count: number, first, second }) =>
    number === 2
      ? `entre los archivos hay dos modelos: '${first}' y '${second}'; elige uno de ellos`
      : `entre los archivos hay ${figure(number)} modelos, como '${first}' y '${second}'; elige uno de ellos`,

  'closed-cracks': ({ count: number, width }) =>
    told(
      'arista',
      ['se unió', 'se unieron'],
      `con otras a través de grietas; la más ancha mide ${rounded(width)} unidades del modelo`,
    )({ count: number }),
  'closed-t-junctions': told(
    'arista',
    ['se cortó', 'se cortaron'],
    'en vértices de sus vecinas para cerrar una grieta',
  ),
  'crossing-bodies': ({ count: number, unitable }) =>
    `${count(number, 'par de cuerpos se atraviesa', 'pares de cuerpos se atraviesan')}: ` +
    'sus piezas chocarían al montarlas' +
    (unitable > 0 ? ' (--crossing unite los une)' : '; únelos en el programa de modelado'),
  'crossings-unchecked': ({ count: number }) =>
    `${counted.faces(number)} ${choose(number, 'es demasiado', 'son demasiadas')} para mirar si unos cuerpos atraviesan otros o están dentro de otros`,
  'counts-from-zero': () =>
    'el archivo cuenta sus vértices desde 0, y no desde 1 como su formato, y se leyó así',
  'cut-nonorientable': told(
    'arista',
    ['se cortó', 'se cortaron'],
    'porque la superficie tiene un solo lado',
  ),
  'cut-off': (params) =>
    `${prefix(params)}el archivo termina demasiado pronto; se usa lo que hay antes, ${counted.faces(params.count)}`,
  'decimal-commas': ({ count: number }) =>
    `${count(number, 'número tiene una coma y se leyó', 'números tienen una coma y se leyeron')} como si fuera un punto decimal`,
  'dropped-degenerate-faces': told('cara', dropped, 'por no tener área'),
  'dropped-duplicate-faces': told('cara', dropped, 'por repetir otra'),
  'dropped-inner-bodies': ({ count: number, faces }) =>
    `${count(number, 'cuerpo', 'cuerpos')} (${counted.faces(faces)}) ${choose(number, 'se dejó', 'se dejaron')} fuera, porque nadie ve lo que está dentro de otro`,
  'dropped-misnumbered-faces': (params) =>
    told('cara', dropped, 'por nombrar un vértice que el archivo no tiene')(params) +
    suffix(params),
  'dropped-placeless-faces': (params) =>
    told('cara', dropped, 'por un vértice sin coordenadas que se puedan usar')(params) +
    suffix({ ...params, count: 1 }),
  'dropped-unused-vertices': told('vértice', dropped, 'por no usarse en ninguna cara'),
  'filled-holes': ({ count: number }) =>
    `${count(number, 'agujero se rellenó', 'agujeros se rellenaron')} con caras nuevas, de los colores de al lado`,
  'flattened-faces': ({ count: number, distance }) =>
    told(
      'cara',
      ['quedó', 'quedaron'],
      `exactamente ${choose(number, 'plana, tal como está dibujada', 'planas, tal como están dibujadas')}; ninguna esquina se movió más de ${rounded(distance)} unidades del modelo`,
    )({ count: number }),
  'flipped-faces': told(
    'cara',
    ['se giró', 'se giraron'],
    'para que todas tengan el mismo lado por fuera',
  ),
  'halved-edges': told(
    'arista',
    ['se partió', 'se partieron'],
    'en dos, porque dos aristas unían los mismos vértices',
  ),
  'huge-holes': ({ count: number, edges }) =>
    `${count(number, 'agujero se queda abierto', 'agujeros se quedan abiertos')}: solo se rellenan agujeros de ${figure(edges)} aristas como mucho`,
  'ignored-elements': ignoredElements,
  'inner-bodies': ({ count: number }) =>
    `${count(number, 'cuerpo está', 'cuerpos están')} dentro de otro, donde nadie ${choose(number, 'lo', 'los')} verá (--inside drop ${choose(number, 'lo', 'los')} deja fuera)`,
  'lost-picture-places': ({ count: number }) =>
    `${count(number, 'esquina de caras nombra', 'esquinas de caras nombran')} un lugar de la imagen que el archivo no tiene; estas caras muestran su color liso`,
  'merged-two-sided': told(
    'cara',
    ['venía', 'venían'],
    'otra vez desde el otro lado; ahora los dos lados son una sola piel de papel',
  ),
  'missing-endsolid': () => "el archivo termina sin 'endsolid'; pueden faltar triángulos al final",
  'not-united': ({ count: number, open }) =>
    `${count(number, 'cuerpo que atraviesa otros no se pudo', 'cuerpos que atraviesan otros no se pudieron')} unir con ellos` +
    (open === number
      ? ': solo lo que está cerrado tiene interior (--fill-holes all lo cierra)'
      : '; únelos en el programa de modelado'),
  'open-border': openBorder,
  'open-holes': openHoles,
  'other-format': ({ ending, format }) => `el archivo se llama .${ending}, pero contiene ${format}`,
  'self-crossing-bodies': ({ count: number }) =>
    `${count(number, 'cuerpo se atraviesa', 'cuerpos se atraviesan')} a sí ${choose(number, 'mismo', 'mismos')}: sus piezas ` +
    'chocarían al montarlas; arréglalo en el programa de modelado',
  'split-nonmanifold-edges': ({ count: number }) =>
    count(
      number,
      'arista con más de dos caras se separó',
      'aristas con más de dos caras se separaron',
    ),
  'split-nonmanifold-vertices': ({ count: number }) =>
    count(
      number,
      'vértice donde las superficies solo se tocan se separó',
      'vértices donde las superficies solo se tocan se separaron',
    ),
  'trailing-bytes': ({ count: number }) =>
    count(
      number,
      'byte después del último triángulo no se usó',
      'bytes después del último triángulo no se usaron',
    ),
  'trailing-lines': ({ count: number }) =>
    count(
      number,
      'línea después de la última cara no se usó',
      'líneas después de la última cara no se usaron',
    ),
  'triangulated-polygons': ({ count: number }) =>
    `${count(number, 'cara con más de tres esquinas se cortó', 'caras con más de tres esquinas se cortaron')} en triángulos`,
  'unfilled-holes': ({ count: number }) =>
    `${count(number, 'agujero se queda abierto', 'agujeros se quedan abiertos')}: cualquier cara ahí atravesaría el modelo o quedaría encima de él`,
  'united-bodies': ({ count: number, faces }) =>
    `${count(number, 'cuerpo que atravesaba otro se unió', 'cuerpos que se atravesaban se unieron')}` +
    (faces > 0 ? `; no queda nada de ${counted.faces(faces)} del interior` : ''),
  'welded-vertices': told(
    'vértice',
    ['se juntó', 'se juntaron'],
    'con otros que estaban en el mismo sitio',
  ),
  'wrong-count': ({ count: number, announced }) =>
    `la cabecera anuncia ${counted.triangles(announced)}, pero el archivo tiene ${figure(number)}, y se leyeron todos`,
} satisfies Partial<Table>;
