/** A Spanish phrase for every message, which may be part of a line. */
import type { Messages, Table } from '../messages.js';
import { fileMessages } from './files.js';
import { all, choose, count, counted, figure, fixed, parts, pieces, some } from './numbers.js';
import { optionFault } from './options.js';
import { paperMessages } from './paper.js';
import { projectMessages } from './projects.js';
import { readerMessages } from './readers.js';
import { repairMessages } from './repair.js';

const simplify = 'simplifica el modelo a menos caras';

/** What a stage does, to be read after "al" or "para", and what helps where memory ends in it. */
const stages = {
  read: ['leer y reparar el modelo', 'simplifica el modelo en el programa con el que se hizo'],
  learn: ['aprender de los despliegues', simplify],
  cluster: ['cortar el modelo en partes', simplify],
  search: ['buscar plantillas', simplify],
  compact: ['hacer sitio para las pestañas', simplify],
  paper: [
    'colocar las piezas en hojas',
    'elige un tamaño más pequeño, un papel más pequeño o menos caras',
  ],
} as const;

const units = { mm: 'milímetros', cm: 'centímetros', m: 'metros', in: 'pulgadas' } as const;
const sides = { height: 'alto', width: 'ancho', depth: 'fondo' } as const;

function badEdit(params: Messages['bad-edit']): string {
  switch (params.what) {
    case 'no-part-named':
      return 'un cambio tiene que nombrar una parte';
    case 'no-part':
      return `la parte ${figure(params.part)} no existe: el modelo tiene ${counted.parts(params.parts)}`;
    case 'twice':
      return `la parte ${figure(params.part)} aparece dos veces: un solo cambio cada vez por parte`;
    case 'apart':
      return `${parts(params.parts)} no se tocan, así que no pueden ser una sola`;
    case 'into':
      return (
        `de ${parts(params.parts)} no se pueden hacer ${counted.parts(params.into)}: pueden ser de 1 a ${figure(params.most)}, ` +
        'una por cada cara plana'
      );
  }
}

function badOption(params: Messages['bad-option']): string {
  switch (params.what) {
    case 'height':
    case 'width':
    case 'depth':
      return `el ${sides[params.what]} debe ser mayor que 0 y de ${figure(params.most)} mm como mucho`;
    case 'scale':
      return `el factor debe ser mayor que 0 y de ${figure(params.most)} como mucho`;
    case 'paper':
      return `el papel debe medir entre 0 y ${figure(params.most)} mm`;
    case 'pin-sheet':
      return `la hoja de una pieza fijada debe ser una de las primeras ${figure(params.most)}`;
    case 'parts':
      return `el número de partes debe ser auto o al menos ${figure(params.least)}`;
    case 'proxy':
      return `proxy debe ser ${figure(params.least)} o más`;
    case 'faces':
      return `el número de caras debe ser al menos ${figure(params.least)}`;
    case 'margin':
      return `el margen debe ser de ${figure(params.least)} mm o más, y menos de la mitad del lado corto del papel`;
    case 'sheets':
      return `el número de hojas debe ser un número entero de ${figure(params.least)} a ${figure(params.most)}`;
    case 'flaps':
    case 'flap-height':
      return `la altura de una pestaña debe ser de ${figure(params.least)} a ${figure(params.most)} mm`;
    case 'flap-angle':
      return `el ángulo de las pestañas debe ser de ${figure(params.least)} a ${figure(params.most)} grados`;
    case 'runs':
    case 'clearance':
    case 'fill-holes':
      return `${params.what} debe ser de ${figure(params.least)} a ${figure(params.most)}`;
    case 'repair':
      return `'${params.step}' es un paso de la reparación que no se puede desactivar`;
    case 'names-of-part':
      return 'cada parte puede tener un nombre como mucho';
    case 'pin-piece':
      return 'una pieza fijada se debe nombrar por su parte y una de sus caras';
    case 'pin-place':
      return 'el lugar de una pieza fijada debe ser un número finito';
    case 'name-control':
      return 'el nombre de una parte no debe tener caracteres de control';
    case 'name-colon':
      return 'el nombre de una parte no debe tener dos puntos, que van delante del número de una arista';
    case 'name-length':
      return 'el nombre de una parte debe tener de 1 a 16 caracteres, sin espacios al principio ni al final';
    case 'name-number':
      return 'el nombre de una parte no debe ser un número: los números son de las aristas';
    case 'same-name':
      return `dos partes no pueden llamarse igual, «${params.name}»`;
    case 'flap-edge':
      return `se eligió una pestaña para la arista del vértice ${figure(params.from)} al ${figure(params.to)}, que el modelo no tiene`;
    case 'unreadable':
    case 'written':
      return params.detail;
    default:
      return optionFault(params);
  }
}

function faceTooLarge(params: Messages['face-too-large']): string {
  const { face_width_mm, face_height_mm, width_mm, height_mm, share } = params;
  const paper = fixed(Math.ceil(10 / share) / 10, 1);
  return (
    `a este tamaño, una cara plana de ${figure(face_width_mm, 0)} x ${figure(face_height_mm, 0)} mm es más grande que una hoja de ` +
    `${figure(width_mm, 3)} x ${figure(height_mm, 3)} mm: cabría al ${Math.floor(100 * share)} % del tamaño, ` +
    `o en un papel ${paper} veces más grande`
  );
}

function locked(params: Messages['locked']): string {
  switch (params.what) {
    case 'fold':
      return 'esta arista está fijada: no se corta nunca';
    case 'cut':
      return 'esta arista está fijada: se corta siempre';
    case 'faces':
      return 'un pliegue fijado sujeta las caras donde están';
    case 'loop':
      return 'el anillo no se puede abrir por otro sitio: sus pliegues están fijados';
    case 'parts':
      return `hay pliegues fijados que sujetan las caras: no se pueden hacer ${counted.parts(params.parts)} con ellas`;
  }
}

/** A time that is only estimated; nothing of one that nobody would mind. */
function roughTime(seconds: number): string {
  if (seconds < 12) return '';
  const time =
    seconds < 90
      ? `${Math.round(seconds / 5) * 5} segundos`
      : `${Math.round(seconds / 60)} minutos`;
  return `hacer sus plantillas lleva unos ${time}, y `;
}

function partsRaised(params: Messages['parts-raised']): string {
  if (params.what === 'bodies') {
    const bodies = count(params.bodies, 'cuerpo separado', 'cuerpos separados');
    return `el modelo tiene ${bodies}, así que necesita al menos ese número de partes`;
  }
  return (
    `en ${counted.parts(params.parts)} saldrían ${counted.pieces(params.pieces)}, así que se cortó en ` +
    `${counted.parts(params.instead)}, cada una en una sola pieza`
  );
}

function uncheckedPieces({ what, pieces: names }: Messages['unchecked-pieces']): string {
  const help = 'ayudaría tener más partes o menos caras';
  if (what === 'large') {
    return `${pieces(names)} no se ${choose(names.length, 'pliega', 'pliegan')} girando todos los pliegues por igual, y con tantas caras no se buscó otra forma; ${help}`;
  }
  const reasons = {
    off: 'la búsqueda del plegado está apagada',
    cancelled: 'se canceló antes',
    kept: 'el resultado anterior, que se conserva, no tenía ninguna',
    huge: `con tantas caras se tarda demasiado; ${help}`,
  };
  return `no se buscó ninguna forma de plegar ${pieces(names)}: ${reasons[what]}`;
}

export const messages: Table = {
  ...fileMessages,
  ...repairMessages,
  ...paperMessages,
  ...projectMessages,
  ...readerMessages,

  'bad-edit': badEdit,
  'bad-margin': () => 'los márgenes no dejan nada de la hoja: el papel y el margen no encajan',
  'bad-option': badOption,
  'bad-pin': (params) =>
    params.what === 'outside'
      ? `la pieza ${params.piece} está fijada en parte fuera de la zona imprimible de la hoja ${figure(params.sheet)}`
      : `las piezas ${all(params.pieces)} están fijadas una encima de otra en la hoja ${figure(params.sheet)}`,
  'bad-start': () => 'el resultado anterior no es de este modelo',
  'face-too-large': faceTooLarge,
  internal: ({ what, detail }) => `error interno al ${stages[what][0]}: ${detail}`,
  'no-depth': () => 'el modelo no tiene un fondo que se pueda agrandar o reducir',
  'no-height': () => 'el modelo no tiene un alto que se pueda agrandar o reducir',
  'no-width': () => 'el modelo no tiene un ancho que se pueda agrandar o reducir',
  'out-of-memory': ({ what }) =>
    what === 'file'
      ? 'no hay bastante memoria para el archivo del modelo'
      : `no hay bastante memoria para ${stages[what].join(': ')}`,
  'too-many-faces': ({ faces, most, proposed }) =>
    `el modelo tiene ${figure(faces)} caras planas, y las plantillas de más de ${figure(most)} tardarían horas y serían demasiado pequeñas para plegarlas: --faces ${proposed} hace un modelo más sencillo que se puede plegar`,
  'too-few-sheets': () => 'las piezas no caben en tan pocas hojas a ningún tamaño',

  'edit-place-gone': ({ what }) =>
    ({
      edge: 'allí ya no hay una arista así',
      faces: 'allí ya no hay caras así',
      part: 'allí ya no hay una parte así',
      piece: 'allí ya no hay una pieza así',
    })[what],
  'already-cut': () => 'esta arista ya está cortada',
  'already-joined': () => 'esta arista ya es un pliegue',
  locked,
  'inside-panel': () => 'esta arista está dentro de una cara plana, que queda entera',
  'no-edge': ({ from, to }) =>
    `el modelo no tiene una arista entre las esquinas ${figure(from)} y ${figure(to)}`,
  'no-face': (params) =>
    params.what === 'none'
      ? 'no se nombró ninguna cara'
      : `el modelo tiene las caras de la 0 a la ${figure(params.most)}`,
  'no-net': () => 'una cara junto a esta arista aún no tiene plantilla',
  'no-part': ({ part, parts: number }) =>
    `la parte ${figure(part)} no existe: el modelo tiene ${figure(number)}`,
  'not-in-loop': () => 'cortar ahí no abriría el anillo',
  'not-touching': () => 'las caras no tocan esa parte',
  overlap: ({ what }) =>
    what === 'pieces'
      ? 'las dos piezas se solaparían ahí'
      : 'las caras de la pieza se solaparían, se abra por donde se abra',
  'would-fall-apart': ({ what, part }) =>
    `sin ${what === 'fold' ? 'este pliegue' : 'estas caras'}, la parte ${figure(part)} se desharía en trozos`,

  'files-ignored': ({ files }) =>
    `${count(files.length, 'archivo más que no hacía falta', 'archivos más que no hacían falta')}: ${some(files)}`,
  'faces-above-wish': ({ faces }) =>
    `se dejó de simplificar en ${counted.faces(faces)}: con menos se rompería la superficie`,
  joints: ({ what, count: number }) =>
    `${count(number, 'arista se pega', 'aristas se pegan')} sobre caras que no son su continuación` +
    (what === 'numbered' ? ': busca allí el mismo número' : ''),
  'joints-lost': ({ count: number }) =>
    `${count(number, 'arista que estaba sobre otras caras se soltó', 'aristas que estaban sobre otras caras se soltaron')} al simplificar el modelo: pega a ojo`,
  'large-model': ({ faces, seconds, proposed }) =>
    `el modelo tiene ${counted.faces(faces)}: ${roughTime(seconds)}la mayoría serán demasiado pequeñas ` +
    `para plegarlas; los modelos de papel tienen unos cientos (--faces ${proposed} hace un modelo más sencillo)`,
  'colour-numbers': () =>
    'el archivo da a sus caras números en vez de colores, y no dice qué colores son: no se imprimen',
  'meets-itself': ({ part }) =>
    `la parte ${figure(part)} tiene caras que se atraviesan en el modelo, así que no se puede plegar sin choques`,
  'no-motion': ({ part }) =>
    `no se encontró cómo plegar la parte ${figure(part)} de una vez sin que choquen sus caras`,
  'part-split': ({ what, part, pieces: number }) =>
    `la parte ${figure(part)} ${what === 'no-motion' ? 'no se pliega' : 'no tiene plantilla'} en una sola pieza y se convirtió en ` +
    counted.pieces(number),
  'parts-lowered': ({ panels }) =>
    `el modelo tiene solo ${count(panels, 'cara plana', 'caras planas')}, así que no puede tener más partes`,
  'parts-raised': partsRaised,
  'pin-lost': ({ count: number }) =>
    count(
      number,
      'pieza fijada ya no está como estaba, y se colocó de nuevo',
      'piezas fijadas ya no están como estaban, y se colocaron de nuevo',
    ),
  'small-bodies': ({ count: number, limit_mm }) =>
    `${counted.bodies(number)} del modelo ${choose(number, 'mide', 'miden')} menos de ${figure(limit_mm)} mm y ` +
    choose(number, 'se dejó fuera', 'se dejaron fuera'),
  'smaller-saves-sheets': ({ what, size_mm, instead_mm, sheets, of }) =>
    `con ${figure(size_mm)} mm de ${sides[what]} en vez de ${figure(Math.round(instead_mm))}, debería caber en ` +
    `${counted.sheets(sheets)} en vez de ${figure(of)}`,
  'sheet-split': ({ part, pieces: number }) =>
    `la parte ${figure(part)} es demasiado grande para la hoja y se cortó en ${counted.pieces(number)}`,
  'run-stopped': () =>
    'la búsqueda se paró antes de terminar, y aquí está lo que se había encontrado; vuelve a desplegar para que termine',
  'unchecked-pieces': uncheckedPieces,
  'unit-guessed': ({ unit }) => `no se conoce la unidad del modelo; se tomaron ${units[unit]}`,
  'up-guessed': () =>
    'el archivo no dice qué va arriba; se tomó el eje z, como en la mayoría de los archivos de este formato',
  'weak-necks': ({ pieces: names }) =>
    'hay pliegues de menos de 5 mm que sujetan muchas caras a ambos lados y se pueden romper: refuérzalos con cinta adhesiva por detrás en ' +
    pieces(names),

  'engine-died': ({ reason, times }) =>
    times === undefined
      ? `El motor se paró de repente: ${reason}`
      : `El motor se paró de repente ${count(times, 'vez', 'veces')} en la misma tarea: ${reason}`,
  overtaken: () => 'mientras tanto se deshizo o se rehízo otro paso',
  'no-piece': ({ piece, pieces: number }) =>
    `la pieza ${figure(piece)} no existe: hay ${figure(number)}`,
  'not-pinned': ({ piece }) => `la pieza ${figure(piece)} no está fijada`,
  'not-together': () =>
    'solo los cambios de pestañas, o los que dividen y unen partes, se pueden hacer de una vez',
  'no-legend': () => 'ninguna hoja tiene sitio para la leyenda',
  'beyond-page': ({ by_mm, margin_mm }) =>
    `al corregir para esta impresora, hay líneas que se salen ${fixed(by_mm, 1)} mm del borde de la página; con un margen de ${figure(margin_mm)} mm (--margin ${margin_mm}) se quedan dentro`,
  'missing-glyphs': ({ letters }) =>
    `ninguna fuente tiene ${letters.join(' ')}: en su lugar se imprime un recuadro`,
  'fonts-not-loaded': () =>
    'no se pudieron cargar las fuentes de algunas letras: se verán con las fuentes del programa que abra el archivo',
  'marks-not-free': ({ pieces: names, margin_mm }) =>
    'la máquina busca sus marcas donde se corta algo: ' +
    `un margen de ${figure(margin_mm)} mm las deja libres; ahora ${choose(names.length, 'estorba', 'estorban')} ${pieces(names)}`,
  'cricut-area': ({ sheets, width_mm, height_mm, margin_mm }) =>
    `Cricut imprime y después corta ${Math.floor(width_mm)} x ${Math.floor(height_mm)} mm de este papel como mucho, y ` +
    `${choose(sheets.length, 'la hoja', 'las hojas')} ${all(sheets.map((sheet) => figure(sheet)))} ` +
    `${choose(sheets.length, 'necesita', 'necesitan')} más: corta sin imprimir, o elige un margen de ${figure(margin_mm)} mm`,
};
