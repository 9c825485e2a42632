/** German phrases for what is told of files: why one cannot be read, and what was mended or noticed in it. */
import { fillingFor } from '../../model/holes.js';
import type { Messages, Table } from '../messages.js';
import { choose, count, figure, rounded } from './numbers.js';

const quoted = (word: string): string => `'${word}'`;

const places: Readonly<Record<string, string>> = {
  line: 'Zeile',
  vertex: 'Ecke',
  face: 'Fläche',
  element: 'Element',
  triangle: 'Dreieck',
  count: 'Zahl',
};

/** "Zeile 23: ", or nothing where no place is known. */
function prefix({ place, at }: { place?: string; at?: number }): string {
  return place === undefined || at === undefined ? '' : `${places[place] ?? place} ${figure(at)}: `;
}

/** Where something is, after its sentence: " (Zeile 23)", or of several where the first one is. */
function suffix(params: { place?: string; at?: number; count: number }): string {
  const place = prefix(params).slice(0, -2);
  if (place === '') return '';
  return params.count > 1 ? ` (zuerst: ${place})` : ` (${place})`;
}

const plural = { Ecke: 'Ecken', Fläche: 'Flächen', Kante: 'Kanten' } as const;

/** "1 Fläche wurde umgedreht", "2 Flächen wurden umgedreht" */
function was(noun: keyof typeof plural, what: string): (params: { count: number }) => string {
  return ({ count: number }) =>
    `${count(number, noun, plural[noun])} ${choose(number, 'wurde', 'wurden')} ${what}`;
}

const saveAs =
  'speichere es als GLB, OBJ, STL, 3MF, PLY oder OFF in dem Programm, das es gemacht hat';
const readFormats = 'gelesen werden OBJ, STL, OFF, PLY, GLB, glTF, 3MF, PDO und FOLD';

/** Endings of formats that are read, and whose contents say that they are. */
const readByContents: readonly string[] = ['glb', 'gltf', '3mf', 'pdo', 'zip'];

/** Models and projects of other programs, by the words of the engine or by the endings of their names. */
const models: Readonly<Record<string, string>> = {
  glb: 'ein GLB-Modell (binäres glTF)',
  gltf: 'ein glTF-Modell',
  '3mf': 'ein 3MF-Modell',
  fbx: 'ein FBX-Modell',
  step: 'ein STEP-Modell',
  stp: 'ein STEP-Modell',
  iges: 'ein IGES-Modell',
  igs: 'ein IGES-Modell',
  blend: 'ein Blender-Projekt',
  skp: 'ein SketchUp-Modell',
  '3dm': 'ein Rhino-Modell',
  vrml: 'ein VRML-Modell',
  wrl: 'ein VRML-Modell',
  vox: 'ein MagicaVoxel-Modell',
  draco: 'ein Draco-Modell',
  drc: 'ein Draco-Modell',
  dae: 'ein COLLADA-Modell (DAE)',
  x3d: 'ein X3D-Modell',
  amf: 'ein AMF-Modell',
  '3ds': 'ein 3DS-Modell',
  max: 'ein 3ds-Max-Projekt',
  c4d: 'ein Cinema-4D-Projekt',
  ma: 'ein Maya-Projekt',
  mb: 'ein Maya-Projekt',
  lwo: 'ein LightWave-Modell',
  usd: 'ein USD-Modell',
  usda: 'ein USD-Modell',
  usdc: 'ein USD-Modell',
  usdz: 'ein USDZ-Modell',
  f3d: 'ein Fusion-Projekt',
  sldprt: 'ein SolidWorks-Teil',
  scad: 'ein OpenSCAD-Programm',
  fcstd: 'ein FreeCAD-Projekt',
};

/** Other files that people take for models. */
const others: Readonly<Record<string, string>> = {
  zstandard: 'ein gepacktes Blender-Projekt oder ein anderes Zstandard-Archiv',
  dxf: 'eine DXF-Zeichnung',
  dwg: 'eine DWG-Zeichnung',
  pdf: 'ein PDF-Dokument',
  ps: 'ein PostScript-Dokument',
  png: 'ein PNG-Bild',
  jpeg: 'ein JPEG-Bild',
  gif: 'ein GIF-Bild',
  gzip: 'ein gzip-Archiv',
  '7z': 'ein 7-Zip-Archiv',
  rar: 'ein RAR-Archiv',
  'git-lfs': 'ein Git-LFS-Verweis auf ein Modell',
  svg: 'eine SVG-Zeichnung',
  html: 'eine Webseite',
  xml: 'ein XML-Dokument',
  json: 'ein JSON-Dokument',
  zip: 'ein ZIP-Archiv',
};

function badHeader(params: Messages['bad-header']): string {
  switch (params.what) {
    case 'property-type':
      return `${prefix(params)}${quoted(params.word)} ist keine Art von Eigenschaft`;
    case 'encoding':
      return `${prefix(params)}${quoted(params.word)} ist keine PLY-Kodierung`;
    case 'ply-magic':
      return `${prefix(params)}eine PLY-Datei beginnt mit 'ply', diese mit ${quoted(params.word)}`;
    case 'off-magic':
      return `${prefix(params)}eine OFF-Datei beginnt mit OFF, diese mit ${quoted(params.word)}`;
    case 'keyword':
      return `${prefix(params)}${quoted(params.word)} ist kein Wort für den Kopf der Datei`;
    case 'element-count':
      return `${prefix(params)}das Element ${quoted(params.element)} braucht eine Zahl, die nicht negativ ist`;
    case 'property-first':
      return `${prefix(params)}eine Eigenschaft steht vor jedem Element`;
    case 'no-format':
      return `${prefix(params)}der Kopf der Datei endet ohne eine Zeile mit 'format'`;
    case 'counts':
      return `${prefix(params)}die Zahlen dürfen nicht negativ sein`;
    case 'dimensions':
      return `die Ecken haben ${figure(params.dimensions)} Dimensionen; nur Modelle mit 3 lassen sich abwickeln`;
    case 'property': {
      const list = params.property === 'vertex_indices' ? ', die eine Liste ist' : '';
      return `das Element ${quoted(params.element)} braucht eine Eigenschaft ${quoted(params.property)}${list}`;
    }
  }
}

function badIndex(params: Messages['bad-index']): string {
  const { index, vertices } = params;
  const face = `${prefix(params)}eine Fläche nennt die Ecke ${figure(index)}`;
  if (params.what === 'before') return `${face}, aber davor kommen nur ${figure(vertices)} Ecken`;
  const from = params.first === 0 ? ', von 0 gezählt' : '';
  return `${face}, aber die Datei hat ${figure(vertices)} Ecken${from}`;
}

function badNumber(params: Messages['bad-number']): string {
  const word = `${prefix(params)}${quoted(params.word)}`;
  if (params.what === 'comma') return `${word} hat ein Komma, wo keines erwartet wird`;
  return `${word} steht, wo eine ${params.what === 'whole' ? 'ganze Zahl' : 'Zahl'} erwartet wird`;
}

const noFaces = {
  nothing: 'die Datei hat weder Ecken noch Flächen',
  vertices:
    'die Datei hat Ecken, aber keine Flächen; Punkte und Linien allein lassen sich nicht abwickeln',
  surfaces: "die Datei hat Freiformflächen ('surf'), aber keine ebenen; speichere sie als Polygone",
  model: 'das Modell hat keine Flächen',
} as const;

function truncated(params: Messages['truncated']): string {
  switch (params.what) {
    case 'number':
      return `${prefix(params)}die Datei endet, wo eine Zahl erwartet wird`;
    case 'coordinates':
      return `${prefix(params)}die Ecke hat weniger als 3 Koordinaten`;
    case 'corners':
      return `${prefix(params)}die Fläche hat weniger Ecken als angekündigt`;
    case 'face':
      return `${prefix(params)}die Datei endet mitten in einer Fläche`;
    case 'ply-header':
      return `${prefix(params)}die Datei endet vor 'end_header'`;
    case 'more':
      return `${prefix(params)}die Datei endet hier, aber mehr ist angekündigt`;
    case 'stl-header':
      return `die Datei hat ${figure(params.bytes)} Bytes, zu wenige für den Kopf eines binären STL`;
    case 'triangles':
      return `${prefix(params)}die Datei endet hier, aber ihr Kopf kündigt ${figure(params.announced)} Dreiecke an`;
    case 'element':
      return `${prefix(params)}die Datei endet hier, aber ihr Kopf kündigt vom Element ${quoted(params.element)} ${figure(params.announced)} an`;
    case 'keyword':
      return `${prefix(params)}die Datei endet, wo ${quoted(params.expected)} erwartet wird`;
    case 'vertices':
    case 'faces': {
      const noun = params.what === 'faces' ? 'Flächen' : 'Ecken';
      return `${prefix(params)}die Datei endet nach ${figure(params.done)} von ${figure(params.announced)} ${noun}`;
    }
    case 'header-only':
      return `${prefix(params)}die Datei endet nach ihrem Kopf`;
  }
}

/** What a file of a format that is not read is, and what to do. */
function unread(format: string): string {
  const model = models[format];
  if (model !== undefined) return `ist ${model} und wird nicht gelesen; ${saveAs}`;
  return `ist ${others[format] ?? format} und wird nicht gelesen; ${readFormats}`;
}

function unknownFormat(params: Messages['unknown-format']): string {
  switch (params.what) {
    case 'contents':
      return `die Datei ${unread(params.format)}`;
    case 'file':
      return `'${params.file}' ${unread(params.format)}`;
    case 'ending':
      // Readers see by its contents whether a file is theirs.
      if (readByContents.includes(params.ending)) {
        return `die Datei heißt .${params.ending}, beginnt aber nicht so: Sie ist beschädigt oder von anderer Art; hol sie noch einmal, oder speichere sie neu`;
      }
      return params.ending in models
        ? `die Datei, nach ihrer Endung, ${unread(params.ending)}`
        : `Dateien mit der Endung '.${params.ending}' werden nicht gelesen; ${readFormats}`;
    case 'nothing':
      return `weder der Inhalt der Datei noch eine Endung ihres Namens verraten das Format; ${readFormats}`;
  }
}

function ignoredElements(params: Messages['ignored-elements']): string {
  const { points, lines, curves, surfaces } = params;
  const kinds = [
    [points, 'Punkt', 'Punkte'],
    [lines, 'Linie', 'Linien'],
    [curves, 'Freiformkurve', 'Freiformkurven'],
    [surfaces, 'Freiformfläche', 'Freiformflächen'],
  ] as const;
  const found = kinds.filter(([number]) => number > 0);
  const list = found.map(([number, one, many]) => count(number, one, many)).join(', ');
  return `nicht benutzt, denn nur ebene Flächen falten sich: ${list}`;
}

function openBorder(params: Messages['open-border']): string {
  if (params.what === 'edge') {
    return 'nur eine Fläche hat diese Kante: Dort gibt es nichts zu verbinden';
  }
  const edges = `${count(params.count, 'Kante', 'Kanten')} ${choose(params.count, 'liegt', 'liegen')}`;
  return (
    `${edges} am Rand von ${count(params.bodies, 'offenen Oberfläche', 'offenen Oberflächen')} ohne Volumen, gedruckt als eine Lage Papier, deren leerer Rücken zu sehen ist; Lücken, die breiter sind als ${rounded(params.gap)} der Größe des Modells ` +
    'oder breit gegen die Kanten daneben, bleiben offen'
  );
}

function openHoles(params: Messages['open-holes']): string {
  const { count: number, percent, small, small_percent } = params;
  const widest = `${choose(number, '', 'das breiteste ')}${figure(percent)} % der längsten Seite des Modells breit`;
  const all = `--fill-holes ${fillingFor(percent)} füllt ${choose(number, 'es', 'sie')}`;
  const few = `, --fill-holes ${small_percent} nur ${choose(small, 'das kleine', `die ${figure(small)} kleinen`)}`;
  return (
    `${count(number, 'Loch bleibt', 'Löcher bleiben')} offen, ${widest} ` +
    `(${all}${small > 0 && small < number ? few : ''})`
  );
}

export const fileMessages = {
  'bad-header': badHeader,
  'bad-index': badIndex,
  'bad-number': badNumber,
  'bad-size': ({ least, most }) =>
    `die Größe des Modells ist außerhalb dessen, was geht: ${least.toExponential()} bis ${most.toExponential().replace('+', '')}`,
  'bad-syntax': (params) =>
    `${prefix(params)}${quoted(params.word)} steht, wo ${quoted(params.expected)} erwartet wird`,
  'bad-text': (params) => `${prefix(params)}im Text steht ein NUL-Byte; die Datei ist beschädigt`,
  'empty-file': () => 'die Datei ist leer',
  'no-area': ({ what }) =>
    what === 'point'
      ? 'alle Ecken des Modells liegen an derselben Stelle'
      : 'keine Fläche des Modells hat einen Inhalt',
  'no-faces': ({ what }) => noFaces[what],
  'not-finite': (params) =>
    params.what === 'weight'
      ? `${prefix(params)}die vierte Koordinate einer Ecke darf nicht 0 sein`
      : `${prefix(params)}eine Koordinate ist keine endliche Zahl`,
  'too-many-corners': ({ face, corners, most }) =>
    `Fläche ${figure(face)} hat ${figure(corners)} Ecken; bis zu ${figure(most)} gehen`,
  truncated,
  'unknown-format': unknownFormat,
  'no-model': ({ count: number }) =>
    `keine der ${figure(number)} Dateien ist ein Modell, das gelesen wird; ${readFormats}`,
  'several-models': ({ count: number, first, second }) =>
    number === 2
      ? `unter den Dateien sind zwei Modelle: '${first}' und '${second}'; wähle eines davon`
      : `unter den Dateien sind ${figure(number)} Modelle, darunter '${first}' und '${second}'; wähle eines davon`,

  'closed-cracks': ({ count: number, width }) =>
    was(
      'Kante',
      `über Risse hinweg mit anderen verbunden, der breiteste ${rounded(width)} Einheiten des Modells breit`,
    )({ count: number }),
  'closed-t-junctions': was('Kante', 'an Ecken ihrer Nachbarn geteilt, um einen Riss zu schließen'),
  'crossing-bodies': ({ count: number, unitable }) =>
    `${count(number, 'Paar von Körpern geht', 'Paare von Körpern gehen')} durcheinander: ` +
    'Ihre Teile würden beim Zusammenbauen zusammenstoßen' +
    (unitable > 0 ? ' (--crossing unite vereint sie)' : '; vereine sie im Modellierprogramm'),
  'crossings-unchecked': ({ count: number }) =>
    `${count(number, 'Fläche ist', 'Flächen sind')} zu viel, um nachzusehen, ob Körper durcheinander gehen oder ineinander liegen`,
  'counts-from-zero': () =>
    'die Datei zählt ihre Ecken von 0, nicht von 1 wie ihr Format, und wurde so gelesen',
  'cut-nonorientable': was('Kante', 'aufgeschnitten, weil die Oberfläche nur eine Seite hat'),
  'cut-off': (params) =>
    `${prefix(params)}die Datei endet zu früh; was davor steht, ${count(params.count, 'Fläche', 'Flächen')}, wird benutzt`,
  'decimal-commas': ({ count: number }) =>
    `${count(number, 'Zahl hat ein Komma und wurde', 'Zahlen haben ein Komma und wurden')} gelesen, als wäre es ein Dezimalpunkt`,
  'dropped-degenerate-faces': was('Fläche', 'weggelassen, weil sie keinen Inhalt haben'),
  'dropped-duplicate-faces': was('Fläche', 'weggelassen, weil sie doppelt da waren'),
  'dropped-inner-bodies': ({ count: number, faces }) =>
    `${count(number, 'Körper', 'Körper')} (${count(faces, 'Fläche', 'Flächen')}) ${choose(number, 'wurde', 'wurden')} weggelassen, weil niemand sieht, was in einem anderen liegt`,
  'dropped-misnumbered-faces': (params) =>
    was('Fläche', 'weggelassen, weil die Datei eine ihrer Ecken nicht hat')(params) +
    suffix(params),
  'dropped-placeless-faces': (params) =>
    was('Fläche', 'weggelassen wegen einer Ecke ohne brauchbare Koordinaten')(params) +
    suffix({ ...params, count: 1 }),
  'dropped-unused-vertices': was('Ecke', 'weggelassen, da keine Fläche sie benutzt'),
  'filled-holes': ({ count: number }) =>
    `${count(number, 'Loch wurde', 'Löcher wurden')} mit neuen Flächen gefüllt, in den Farben daneben`,
  'flattened-faces': ({ count: number, distance }) =>
    was(
      'Fläche',
      `genau eben gemacht, wie gezeichnet; keine Ecke rückte um mehr als ${rounded(distance)} Einheiten des Modells`,
    )({ count: number }),
  'flipped-faces': was('Fläche', 'umgedreht, damit bei allen dieselbe Seite außen ist'),
  'halved-edges': was('Kante', 'halbiert, weil zwei Kanten dieselben Ecken verbanden'),
  'huge-holes': ({ count: number, edges }) =>
    `${count(number, 'Loch bleibt', 'Löcher bleiben')} offen: Nur Löcher mit höchstens ${figure(edges)} Kanten werden gefüllt`,
  'ignored-elements': ignoredElements,
  'inner-bodies': ({ count: number }) =>
    `${count(number, 'Körper liegt', 'Körper liegen')} in einem anderen, wo ${choose(number, 'ihn', 'sie')} niemand sehen wird (--inside drop lässt ${choose(number, 'ihn', 'sie')} weg)`,
  'lost-picture-places': ({ count: number }) =>
    `${count(number, 'Ecke von Flächen nennt', 'Ecken von Flächen nennen')} eine Stelle im Bild, die die Datei nicht hat; diese Flächen zeigen ihre einfache Farbe`,
  'merged-two-sided': was(
    'Fläche',
    'ein zweites Mal von der anderen Seite angegeben; beide Seiten sind jetzt eine Haut aus Papier',
  ),
  'missing-endsolid': () => "die Datei endet ohne 'endsolid'; an ihrem Ende können Dreiecke fehlen",
  'not-united': ({ count: number, open }) =>
    `${count(number, 'Körper, der durch andere geht, ließ', 'Körper, die durch andere gehen, ließen')} sich nicht mit ihnen vereinen` +
    (open === number
      ? ': Nur was geschlossen ist, hat ein Inneres (--fill-holes all schließt es)'
      : '; vereine sie im Modellierprogramm'),
  'open-border': openBorder,
  'open-holes': openHoles,
  'other-format': ({ ending, format }) => `die Datei heißt .${ending}, enthält aber ${format}`,
  'self-crossing-bodies': ({ count: number }) =>
    `${count(number, 'Körper geht', 'Körper gehen')} durch sich selbst: Seine Teile würden ` +
    'beim Zusammenbauen zusammenstoßen; bessere das im Modellierprogramm aus',
  'split-nonmanifold-edges': ({ count: number }) =>
    `${count(number, 'Kante mit mehr als zwei Flächen ging', 'Kanten mit mehr als zwei Flächen gingen')} auseinander`,
  'split-nonmanifold-vertices': ({ count: number }) =>
    `${count(number, 'Ecke, an der Oberflächen sich nur berühren, ging', 'Ecken, an denen Oberflächen sich nur berühren, gingen')} auseinander`,
  'trailing-bytes': ({ count: number }) =>
    `${figure(number)} Bytes nach dem letzten Dreieck wurden übergangen`,
  'trailing-lines': ({ count: number }) =>
    `${count(number, 'Zeile', 'Zeilen')} nach der letzten Fläche ${choose(number, 'wurde', 'wurden')} übergangen`,
  'triangulated-polygons': ({ count: number }) =>
    `${count(number, 'Fläche', 'Flächen')} mit mehr als drei Ecken ${choose(number, 'wurde', 'wurden')} in Dreiecke geteilt`,
  'unfilled-holes': ({ count: number }) =>
    `${count(number, 'Loch bleibt', 'Löcher bleiben')} offen: Jede Fläche darin würde durch das Modell gehen oder auf ihm liegen`,
  'united-bodies': ({ count: number, faces }) =>
    `${count(number, 'Körper', 'Körper')}, die durcheinander gingen, wurden vereint` +
    (faces > 0 ? `; von ${count(faces, 'Fläche', 'Flächen')} im Inneren ist nichts mehr da` : ''),
  'welded-vertices': was('Ecke', 'mit anderen an derselben Stelle vereint'),
  'wrong-count': ({ count: number, announced }) =>
    `der Kopf der Datei kündigt ${figure(announced)} Dreiecke an, aber sie hat ${figure(number)}, die alle gelesen wurden`,
} satisfies Partial<Table>;
