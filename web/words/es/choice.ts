/** What is said in Spanish of a model that is chosen and looked at before it is unfolded. */
import type { Words } from '../words.js';
import { choose, counted, figure, large, rounded, some } from './numbers.js';
import { excess } from './readers.js';

const levels = { easy: 'Fácil', medium: 'Medio', hard: 'Difícil' } as const;

export const choice: Words['choice'] = {
  opening: (files) => `Abriendo: ${some(files)}`,
  chosen: (files) => `Elegido: ${some(files)}`,
  fileTooLarge: (file, fault) =>
    `«${file}» es demasiado grande: tiene ${excess(fault)}. Guárdalo con menos caras o en un formato binario.`,
  tooMuch: (fault) =>
    `Eso es demasiado: tiene ${excess(fault)}. Elige un modelo y lo que va con él.`,
  notLoaded: (file) => `«${file}» no se puede cargar.`,
  notLetIn: (file) =>
    `«${file}» no se puede cargar: está en otro sitio web, y los navegadores solo lo traen si los dos sitios lo permiten. Guarda el archivo en tu dispositivo y suéltalo aquí.`,
  unreadable: (file) =>
    `«${file}» no se puede leer: es una carpeta, se movió o no está permitido abrirlo.`,
  unreadableDrop: (file) => `«${file}» no se puede leer: se movió o no está permitido abrirlo.`,
  noFile:
    'Eso no era un archivo. Elige un archivo GLB, OBJ, STL, 3MF, PLY, OFF, PDO o FOLD, o un ZIP que tenga uno.',
  empty: (file) => `«${file}» está vacío: no hay nada que desplegar.`,
  noSamples: 'No se pueden cargar los ejemplos. Tus propios modelos funcionan igual.',
  sample: (name, faces) => `${name}, ${counted.faces(faces)}`,
  effort: (level, pieces) => `${levels[level]}: ${counted.pieces(pieces)}`,
  pending: (names) => `Sin aplicar todavía: ${names}.`,
};

function length(mm: number): string {
  if (mm < 10) return `${rounded(mm)} mm`;
  if (mm < 1000) return `${rounded(mm / 10, mm < 100 ? 2 : 3)} cm`;
  return `${rounded(mm / 1000)} m`;
}

export const check: Words['check'] = {
  length,
  triangles: (faces) => `Este modelo tiene ${large(faces)} triángulos.`,
  fine: 'Está bien para papel.',
  proposed: (proposal) =>
    `Los modelos de papel tienen de 200 a 1500, así que aquí se han puesto ${large(proposal)}: la imagen muestra lo que queda de su forma.`,
  making: (wanted) => `Haciendo un modelo con ${wanted} …`,
  shown: (faces) => `La imagen tiene ${large(faces)} triángulos.`,
  asItIs: (faces) => `tal como es: ${large(faces)}`,
  all: (faces) => `los ${large(faces)} triángulos`,
  some: (faces) => `${large(faces)} triángulos`,
  tooMany: (faces, most) =>
    `Los ${large(faces)} son demasiados: las plantillas de más de ${large(most)} triángulos tardarían horas ` +
    'y serían demasiado pequeñas para plegarlas.',
  bodies: (bodies) =>
    `El modelo está hecho de ${large(bodies)} cuerpos separados, cada uno con sus propias plantillas.`,
  tiny: (bodies) =>
    `${large(bodies)} de ellos ${choose(bodies, 'es muy pequeño', 'son muy pequeños')}: menos del 3 % del largo del modelo. ` +
    `La imagen ${choose(bodies, 'lo', 'los')} muestra en color.`,
  holes: ({ count: number, small, smallPercent }) => {
    const few = `${large(small)} de ellos ${choose(small, 'es pequeño', 'son pequeños')}: como mucho, el ${figure(smallPercent)} % del largo del modelo.`;
    const isMixed = small > 0 && small < number;
    return `El modelo tiene ${large(number)} ${choose(number, 'agujero', 'agujeros')}. ${isMixed ? `${few} ` : ''}Lo que cierra un agujero toma los colores de al lado.`;
  },
  inside: (bodies) =>
    bodies === 1
      ? 'Un cuerpo está dentro de otro, donde nadie lo verá. Sin él hay menos que cortar y pegar.'
      : `${large(bodies)} cuerpos están dentro de otros, donde nadie los verá. Sin ellos hay menos que cortar y pegar.`,
  netsKept:
    'El modelo se corta y se pliega igual que en su archivo, del mismo tamaño si cabe en el papel.',
  netsOffered: (pieces) =>
    pieces === 1
      ? 'El archivo trae su propia plantilla. Consérvala para cortar y plegar como quien lo hizo, o pide plantillas nuevas.'
      : `El archivo trae sus propias plantillas, ${large(pieces)} piezas. Consérvalas para cortar y plegar como quien lo hizo, o pide plantillas nuevas.`,
  size: (p) =>
    `${length(p.height)} de alto, ${length(p.width)} de ancho, ${length(p.depth)} de fondo, junto a un lápiz de ${length(p.pencil)}.`,
  fits: {
    new: 'Tan grande como permite una hoja: cuánto es, se ve al desplegarlo.',
    file: 'Tan grande como en el archivo, o como permite una hoja: cuánto es, se ve al desplegarlo.',
    other: 'Su tamaño se ve al desplegarlo.',
  },
  chooseHeight: 'Elige una altura para verlo junto a un lápiz.',
};

export const form: Words['form'] = {
  height: 'Alto, mm',
  width: 'Ancho, mm',
  depth: 'Fondo, mm',
  scale: 'Factor',
  sheets: 'Máximo de hojas',
  holesUpTo: (percent) => `cerrar hasta el ${figure(percent)} % del largo`,
  solver: {
    tree: 'Arregla un despliegue paso a paso: rápido.',
    genetic: 'Como en el artículo científico: cría plantillas; lento.',
  },
  folding: {
    prefer:
      'De cada plantilla que se pliega sin chocar consigo misma se demuestra que es así; de las demás se avisa.',
    require: 'Una parte sin plantilla que se pliegue se divide en piezas que sí se pliegan.',
    off: 'Basta con que las plantillas queden planas.',
  },
};

const pens =
  'Las líneas rojas se cortan, las azules y verdes se marcan, y las rosas se dibujan con un rotulador.';

export const printing: Words['printing'] = {
  machine: {
    none: 'Para tijeras o cúter.',
    silhouette: `${pens} Con las marcas negras, la máquina encuentra una hoja impresa.`,
    cricut: `${pens} El programa de Cricut pone sus propias marcas.`,
    generic: pens,
  },
  noColours: 'Esta máquina solo recibe líneas.',
  noPartColours: 'Esta máquina cortaría alrededor de estos colores, así que no se ponen.',
  noLooks: 'Este modelo no trae colores propios.',
  longer: (percent) => `un ${percent} % más largas`,
  shorter: (percent) => `un ${percent} % más cortas`,
  correcting: (across, up) =>
    `La corrección está activa: las líneas se dibujan ${across} en horizontal y ${up} en vertical. Imprime otra vez: ahora las reglas miden 50 mm.`,
  notCorrecting: 'Imprime una hoja al 100 % y escribe lo que miden sus reglas.',
  corrected: (across, up) =>
    `El PDF y el SVG están corregidos para tu impresora (${figure(across)} × ${figure(up)} mm)`,
  frame: 'Páginas para imprimir',
  page: (sheet, sheets, width, height) => {
    const size = `${figure(width, 1)} × ${figure(height, 1)} mm`;
    return sheet === null
      ? `Cómo se monta, ${size}`
      : `Hoja ${figure(sheet)} de ${figure(sheets)}, ${size}`;
  },
  allSheets: (sheets) => (sheets === 1 ? 'la única hoja' : `las ${figure(sheets)} hojas`),
  someSheets: (chosen, sheets) => `${figure(chosen)} de ${counted.sheets(sheets)}`,
  unreadableRange: 'Escribe números, como 1-3, 5',
  beyondRange: (sheets) => `Hay hojas de la 1 a la ${figure(sheets)}`,
};
