/** What the cover and the pages with the steps say in Spanish. */
import type { BuildingWords, EdgeList } from '../building.js';
import { all, count, counted, figure } from './numbers.js';

const views = {
  'front-left': 'visto de frente y desde la izquierda',
  'back-right': 'visto por detrás y desde la derecha',
  'front-right': 'visto de frente y desde la derecha',
  'back-left': 'visto por detrás y desde la izquierda',
  above: 'visto desde arriba',
  below: 'visto desde abajo',
} as const;

const marks = {
  'close-first': 'cerrar: inicio',
  'close-last': 'cerrar: última arista',
  'glue-first': 'pegar: inicio',
  'glue-last': 'pegar: última arista',
  valley: 'pliegue en valle',
  border: 'se pega a este color',
} as const;

const ways = { mountain: 'en montaña', valley: 'en valle' } as const;

/** "3 pliegues en montaña", "ningún pliegue en valle" */
const foldsOf = (number: number, way: keyof typeof ways): string =>
  `${number === 0 ? 'ningún pliegue' : counted.folds(number)} ${ways[way]}`;

/** "unos 40 minutos", "unas 3½ horas": nobody works to the minute. */
function duration({ seconds }: { seconds: number }): string {
  const minutes = seconds / 60;
  if (minutes < 57.5) return `unos ${figure(Math.max(5, 5 * Math.round(minutes / 5)))} minutos`;
  const halves = Math.round(minutes / 30);
  if (halves >= 20) return `unas ${figure(Math.round(minutes / 60))} horas`;
  const whole = Math.floor(halves / 2);
  const half = halves % 2 === 1;
  if (whole === 1) return half ? 'más o menos una hora y media' : 'más o menos una hora';
  return `unas ${figure(whole)}${half ? '½' : ''} horas`;
}

function withoutNumber({ edges, unnumbered }: EdgeList): string {
  if (unnumbered === 0) return '';
  if (unnumbered === edges) {
    return edges === 1 ? 'una arista sin número' : `${figure(edges)} aristas sin número`;
  }
  return `y ${counted.edges(unnumbered)} sin número`;
}

function startAndEnd({ edges, first, last }: EdgeList): string {
  if (edges < 2 || first === null) return '.';
  return last === null || last === first
    ? `. Empieza en ${first}.`
    : `. Empieza en ${first}; ${last} va al final.`;
}

function close(list: EdgeList): string {
  const runs = [list.runs.join(', '), withoutNumber(list)].filter((text) => text !== '').join(' ');
  return `Ciérrala por ${runs}${startAndEnd(list)}`;
}

function glue(list: Parameters<BuildingWords['glue']>[0]): string {
  const groups = list.groups.map(({ name, runs }) =>
    runs.length > 0 ? `${name} por ${runs.join(', ')}` : name,
  );
  const rest = withoutNumber(list);
  const along = list.unnumbered === list.edges ? ` por ${rest}` : rest && ` ${rest}`;
  return `Pégala a ${groups.join(', después a ')}${along}${startAndEnd(list)}`;
}

function fold({ folds, crease, turn }: Parameters<BuildingWords['fold']>[0]): string {
  if (folds === 0) return 'No tiene pliegues.';
  const own = ways[crease];
  if (turn === 0) {
    return folds === 1
      ? `Haz su único pliegue ${own}.`
      : `Haz todos sus ${figure(folds)} pliegues ${own}.`;
  }
  const other = ways[crease === 'mountain' ? 'valley' : 'mountain'];
  const others = turn === 1 ? `uno va ${other}` : `${figure(turn)} van ${other}`;
  return `Haz sus ${figure(folds)} pliegues: ${others}, todos los demás ${own}.`;
}

export const building: BuildingWords = {
  pageNote: ({ page, pages }) =>
    `instrucciones, página ${figure(page)} de ${figure(pages)} · para mirar, no para recortar`,
  view: ({ name }) => views[name],
  sizeLabel: () => 'Tamaño final',
  size: ({ width, height, depth }) =>
    `${width} mm de ancho, ${height} mm de alto, ${depth} mm de fondo`,
  amountLabel: () => 'Para recortar',
  amount: ({ pieces, sheets, width, height }) =>
    `${counted.pieces(pieces)} en ${counted.sheets(sheets)} de ${width} × ${height} mm`,
  foldsLabel: () => 'Para plegar',
  folds: ({ mountains, valleys }) =>
    `${foldsOf(mountains, 'mountain')}, ${foldsOf(valleys, 'valley')}`,
  seamsLabel: () => 'Para unir',
  seams: ({ seams }) => counted.seams(seams),
  gluedLabel: () => 'Tiempo con pegamento',
  tapedLabel: () => 'Tiempo con cinta',
  duration,
  mountain: () => 'pliegue en montaña: como un tejado, el lado impreso queda por fuera',
  valley: () => 'pliegue en valle: como un libro abierto, el lado impreso queda por dentro',
  valleyPieces: ({ names, pieces, all: isAll }) => {
    if (pieces === 0) return 'Todos los pliegues son en montaña.';
    if (isAll && pieces > 1) {
      return 'Todas las piezas tienen pliegues en valle: los pasos los muestran en azul.';
    }
    if (isAll) return 'Los pasos muestran en azul los pliegues en valle.';
    const where = names.length > 0 ? all(names) : `${figure(pieces)} de las piezas`;
    return `Solo hay pliegues en valle en ${where}: los pasos los muestran en azul.`;
  },
  howTitle: () => 'Cómo se monta',
  how: () => [
    'Imprime las hojas con las piezas al 100 % en papel grueso (160 a 200 g/m²). Estas páginas pueden ir en papel fino.',
    'Corta por las líneas continuas. Marca todos los pliegues con un bolígrafo gastado y una regla, y después dobla.',
    'Las aristas con el mismo número van juntas. Ve paso a paso y deja secar el pegamento antes del paso siguiente.',
  ],
  piecesTitle: () => 'Las piezas y dónde van',
  sheet: ({ sheet }) => `en la hoja ${figure(sheet)}`,
  faces: ({ faces, flaps }) => `${counted.faces(faces)}, ${counted.flaps(flaps)}`,
  pieceFolds: ({ folds, valleys }) => {
    if (folds === 0) return 'sin pliegues';
    if (valleys === 0) return `${counted.folds(folds)}, ninguno en valle`;
    if (valleys < folds) return `${counted.folds(folds)}, ${figure(valleys)} en valle`;
    return count(folds, 'pliegue, en valle', 'pliegues, todos en valle');
  },
  hidden: () => 'detrás de otras: se dibuja como si esas fueran de cristal',
  strips: ({ runs, strips }) =>
    `Junto a las piezas hay ${strips === 1 ? 'una tira suelta' : `${figure(strips)} tiras sueltas`} de ` +
    `papel, para pegar detrás de las aristas ${runs.join(', ')}.`,
  stepsTitle: () => 'Paso a paso',
  marks: ({ mark }) => marks[mark],
  stepTitle: ({ step, name }) => `Paso ${figure(step)}: pieza ${name}`,
  fold,
  close,
  glue,
  apart: () =>
    'Ninguna de sus aristas se pega a las piezas anteriores: ponla donde muestra la imagen. Si le quedan números, ' +
    'busca allí los mismos.',
  finish: ({ last }) =>
    last === null
      ? 'Esa era la última arista: el modelo está terminado.'
      : `${last} es la última arista de todas: apriétala desde fuera hasta que aguante.`,
};
