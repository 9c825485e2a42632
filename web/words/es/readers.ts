/** Spanish phrases for what is told of archives and of glTF, 3MF and Pepakura files. */
import type { FileExcess } from '../../model/model-files.js';
import type { FoldEntryFault, Messages, Table } from '../messages.js';
import { shown } from '../speech.js';
import { all, choose, count, counted, figure, some } from './numbers.js';

/** What is too much of some files, to be read after "tiene". */
export function excess(fault: FileExcess): string {
  return fault.what === 'too-many'
    ? `más de ${figure(fault.most)} archivos`
    : `${figure(fault.megabytes)} MB, y se pueden leer ${figure(fault.most)} MB`;
}

const exportAgain = 'expórtalo de nuevo';
const again = `consigue el archivo otra vez o ${exportAgain}`;

function badArchive(params: Messages['bad-archive']): string {
  const file = shown(params.file);
  switch (params.what) {
    case 'damaged':
      return `el archivo comprimido '${file}' está dañado o cortado; descárgalo otra vez`;
    case 'bomb':
      return `el archivo comprimido '${file}' ocuparía cientos de veces su tamaño, y ningún modelo hace eso; no se descomprimió`;
    case 'locked':
      return `'${shown(params.entry)}', en el archivo comprimido '${file}', está cerrado con una contraseña; descomprímelo tú y elige el modelo`;
    case 'method':
      return `'${shown(params.entry)}', en el archivo comprimido '${file}', está comprimido de una forma que no se lee; descomprímelo tú y elige el modelo`;
    case 'too-many':
    case 'too-large':
      return `el archivo comprimido '${file}' es demasiado grande: tiene ${excess(params)}; descomprímelo y elige el modelo y lo que va con él`;
  }
}

/** Qué falla en una entrada de una lista, para leer detrás de su nombre. */
function foldEntry(params: FoldEntryFault): string {
  switch (params.what) {
    case 'number':
      return 'no es un número';
    case 'letter':
      return 'no es ninguna de las letras B, M, V y F';
    case 'numbers':
      return `no es una lista de ${figure(params.width)} números`;
    case 'list':
      return `no es una lista de ${figure(params.least)} números o más`;
    case 'index':
      return `es el número ${figure(params.index)}, y solo hay de 0 a ${figure(params.count - 1)}`;
    case 'twice':
      return `es la cara ${figure(params.index)}, que ya está en una plantilla`;
  }
}

function badFold(params: Messages['bad-fold']): string {
  const file = shown(params.file);
  const damaged = `'${file}' está dañado: `;
  switch (params.what) {
    case 'pattern':
      return `'${file}' solo tiene un patrón de pliegues plano, y falta el modelo plegado; guárdalo con su forma plegada («foldedForm»)`;
    case 'flat':
      return `la forma plegada de '${file}' es plana, y solo se despliegan modelos con altura, anchura y profundidad`;
    case 'nothing':
      return `'${file}' es un archivo FOLD sin modelo: falta la forma plegada («foldedForm»); ${again}`;
    case 'cut-off':
      return `'${file}' está cortado: le falta el final; ${again}`;
    case 'no-object':
      return `'${file}' no es un archivo FOLD, aunque se llame así; ${again}`;
    case 'word':
      return `${damaged}en la línea ${figure(params.line)}, carácter ${figure(params.character)}, pone '${shown(params.word)}' donde se espera otra cosa; ${again}`;
    case 'no-frame':
      return `${damaged}el frame ${figure(params.frame)} no está hecho de campos; ${again}`;
    case 'missing':
      return `${damaged}en el frame ${figure(params.frame)} falta '${params.key}'; ${again}`;
    case 'type':
      return `${damaged}en el frame ${figure(params.frame)}, '${params.key}' contiene otra cosa de la que debería; ${again}`;
    case 'times':
      return `${damaged}en el frame ${figure(params.frame)}, los tiempos de '${params.key}' no suben de 0 a 1; ${again}`;
    case 'length':
      return `${damaged}en el frame ${figure(params.frame)}, '${params.key}' tiene ${figure(params.length)} ${choose(params.length, 'entrada', 'entradas')} donde se esperan ${figure(params.expected)}; ${again}`;
    default:
      return `${damaged}en el frame ${figure(params.frame)}, la entrada ${figure(params.entry)} de '${params.key}' ${foldEntry(params)}; ${again}`;
  }
}

function badGltf(params: Messages['bad-gltf']): string {
  const file = shown(params.file);
  switch (params.what) {
    case 'truncated':
      return `'${file}' termina antes que sus datos; ${again}`;
    case 'json':
      return `'${file}' no tiene una descripción de su escena (JSON) que se pueda leer; ${again}`;
    case 'structure':
      return `'${file}' está dañado: sus partes remiten a datos que no están o no se pueden descifrar; ${again}`;
    case 'cycle':
      return `la escena de '${file}' tiene nodos que se contienen unos a otros sin fin; ${exportAgain}`;
    case 'version': {
      const version =
        params.version === '' ? 'sin versión' : `de la versión ${shown(params.version)}`;
      return `'${file}' es glTF ${version}, y se lee la versión 2; ${exportAgain}`;
    }
    case 'extension':
      return `'${file}' guarda su forma de una manera que no se lee (${shown(params.extension)}); expórtalo sin eso`;
    case 'short-buffer': {
      const bytes = `${figure(params.bytes)} de ${figure(params.announced)} bytes`;
      const where =
        params.buffer === ''
          ? `'${file}' tiene`
          : `'${shown(params.buffer)}', que '${file}' necesita, tiene`;
      return `${where} solo ${bytes} de sus datos; ${again}`;
    }
  }
}

function bad3mf(params: Messages['bad-3mf']): string {
  const file = shown(params.file);
  switch (params.what) {
    case 'no-model':
      return `'${file}' es un paquete 3MF sin ningún modelo dentro; ${again}`;
    case 'nothing':
      return `'${file}' no tiene nada que se imprima; guarda otra vez el proyecto con un objeto visible`;
    case 'sliced':
      return `'${file}' solo contiene un trabajo de impresión ya preparado (G-code) y ningún modelo; guarda el proyecto mismo, no el archivo preparado`;
    case 'no-part':
      return `'${file}' remite a '${shown(params.part)}', que no está dentro; ${again}`;
    case 'no-object':
      return `'${file}' remite al objeto ${shown(params.object)} de '${shown(params.part)}', que no está; ${again}`;
    case 'cycle':
      return `el objeto ${shown(params.object)} de '${file}' se contiene a sí mismo, o contiene demasiados otros; ${exportAgain}`;
    case 'xml':
      return `'${file}' está dañado: '${shown(params.part)}' no es XML en la línea ${figure(params.line)}; ${again}`;
    case 'word':
      return `'${file}' está dañado: en la línea ${figure(params.line)} de '${shown(params.part)}' está '${shown(params.word)}' donde se espera otra cosa; ${again}`;
  }
}

function badPdo(params: Messages['bad-pdo']): string {
  const file = shown(params.file);
  switch (params.what) {
    case 'locked':
      return `'${file}' está bloqueado por la persona que lo hizo; pídele un archivo sin bloqueo`;
    case 'hidden':
      return `en '${file}' todos los cuerpos están apagados; enciende uno en Pepakura Designer y guárdalo otra vez`;
    case 'no-faces':
      return `'${file}' es un archivo de Pepakura sin ninguna cara que se pueda plegar; ${again}`;
    case 'old':
      return `'${file}' es del primer Pepakura Designer, y se leen archivos de Pepakura Designer 2 a 6; ábrelo en uno de estos y guárdalo otra vez`;
    case 'version':
      return `'${file}' es de una versión de Pepakura que aquí no se conoce (${figure(params.version)}); guárdalo para Pepakura Designer 2 a 6, o como OBJ`;
    case 'damaged':
      return `'${file}' está dañado o cortado (byte ${figure(params.at)}); consigue el archivo otra vez o guárdalo de nuevo en Pepakura Designer`;
  }
}

/** Those kinds that there are: "3 animaciones y 2 cámaras". */
function kinds(counts: readonly (readonly [number, string, string])[]): string {
  const found = counts.filter(([number]) => number > 0);
  return all(found.map(([number, one, many]) => count(number, one, many)));
}

function missingLooks({ what, files }: Messages['missing-looks']): string {
  const number = files.length;
  const names = some(files);
  const those =
    what === 'pictures'
      ? `${choose(number, 'falta la imagen', 'faltan las imágenes')} ${names}`
      : `${choose(number, 'falta el archivo', 'faltan los archivos')} con los colores e imágenes del modelo, ${names}`;
  const them =
    what === 'pictures'
      ? choose(number, 'elígela', 'elígelas')
      : choose(number, 'elígelo', 'elígelos');
  return `${those}, así que esas caras se quedan lisas; ${them} también, o elige la carpeta entera`;
}

function unreadPictures({ files, kinds: found }: Messages['unread-pictures']): string {
  const number = files.length;
  const what =
    found.length > 0
      ? `${choose(number, 'es', 'son')} de un tipo que no se lee (${all(found)})`
      : choose(number, 'no es una imagen que se pueda leer', 'no son imágenes que se puedan leer');
  const saved = choose(
    number,
    'guárdala como PNG o JPEG y nómbrala',
    'guárdalas como PNG o JPEG y nómbralas',
  );
  return `${some(files)} ${what}; ${saved} así en el modelo`;
}

const lostNets = {
  none: 'el archivo no trae plantillas propias',
  simplified: 'las plantillas del archivo no valen para un modelo con otros triángulos',
  repaired:
    'las plantillas del archivo no se pudieron conservar, porque hubo que reparar sus caras',
  flat: 'las plantillas del archivo no se pudieron conservar, porque atraviesan caras planas',
} as const;

function keptNets({ pieces, uncut, size }: Messages['file-nets-kept']): string {
  const words = [
    pieces === 1
      ? 'se conservó la plantilla del archivo'
      : `se conservaron las ${figure(pieces)} plantillas del archivo`,
  ];
  if (size === 'file') words.push('al tamaño del archivo');
  if (uncut > 0) {
    words.push(
      `pero ${count(uncut, 'corte dentro de caras planas se quitó', 'cortes dentro de caras planas se quitaron')}`,
    );
  }
  return words.join(', ');
}

export const readerMessages = {
  'bad-3mf': bad3mf,
  'bad-archive': badArchive,
  'bad-fold': badFold,
  'bad-gltf': badGltf,
  'bad-pdo': badPdo,
  'missing-files': ({ file, missing }) =>
    `'${shown(file)}' necesita ${some(missing)}, que ${choose(missing.length, 'falta; elígelo', 'faltan; elígelos')} también, ` +
    'o elige la carpeta entera',
  'no-model-in-archive': ({ file, files }) =>
    files.length === 0
      ? `en el archivo comprimido '${shown(file)}' no hay nada`
      : `ningún archivo del archivo comprimido '${shown(file)}' es un modelo que se lea; tiene ${some(files)}`,
  'reader-not-loaded': () =>
    'el lector de este formato no se pudo cargar; mira la conexión e inténtalo otra vez',
  'uniter-not-loaded': () =>
    'lo que une cuerpos no se pudo cargar; mira la conexión e inténtalo otra vez',
  'too-many-triangles': ({ most }) =>
    `el modelo tiene más de ${figure(most)} triángulos, y son más de los que se pueden leer; ` +
    'simplifícalo en el programa con el que se hizo',

  'broken-faces': ({ count: number }) =>
    `${count(number, 'cara descartada', 'caras descartadas')}: ${choose(number, 'le', 'les')} faltan esquinas, ` +
    `o ${choose(number, 'nombra', 'nombran')} vértices que no están en el archivo`,
  'damaged-extras': () =>
    'después de su forma, el archivo está dañado: se han perdido algunos colores e imágenes y las plantillas del archivo; guárdalo otra vez en Pepakura Designer',
  'damaged-looks': () =>
    `los colores e imágenes del archivo están dañados: solo se leyó su forma; ${exportAgain}`,
  'large-pictures': ({ files, most, most_mb, most_pixels }) =>
    `${some(files)} se ${choose(files.length, 'ha', 'han')} dejado fuera: se pueden usar hasta ${figure(most)} imágenes de ` +
    `${figure(most_mb)} MB en total, cada una de ${figure(most_pixels / 1e6, 0)} millones de píxeles como mucho; ` +
    `${choose(files.length, 'hazla más pequeña', 'hazlas más pequeñas')} en un programa de imágenes`,
  'lost-looks': ({ count: number }) =>
    `${count(number, 'color o imagen que el modelo usa no está', 'colores o imágenes que el modelo usa no están')} ` +
    `en el archivo, así que esas caras se quedan blancas; ${exportAgain}`,
  'missing-looks': missingLooks,
  'picture-guessed': ({ file }) =>
    `el modelo no nombra ninguna imagen, así que se le puso ${shown(file)}, la única que hay a su lado`,
  'simplified-looks': () =>
    'donde el archivo pone colores o imágenes unos sobre otros o los mezcla, se toma la imagen de encima ' +
    'o, si no, el color principal',
  'unknown-materials': ({ names }) =>
    `${choose(names.length, 'el material', 'los materiales')} ${some(names)} del modelo no ${choose(names.length, 'está', 'están')} ` +
    'en ninguno de sus archivos MTL, así que lo que lo lleva se queda blanco',
  'unread-libraries': ({ files }) =>
    choose(
      files.length,
      `${some(files)}, que debería describir los colores e imágenes del modelo, está dañado o no es un archivo MTL`,
      `${some(files)}, que deberían describir los colores e imágenes del modelo, están dañados o no son archivos MTL`,
    ) + '; exporta otra vez el modelo',
  'unread-pictures': unreadPictures,

  'archive-choice': ({ file, others }) =>
    `el archivo comprimido tiene ${figure(others.length + 1)} modelos; se tomó '${shown(file)}' en vez de ${some(others)}`,
  'not-for-printing': ({ supports, modifiers, negatives, unprinted }) =>
    `se deja fuera, porque el archivo dice que no se imprime: ${kinds([
      [supports, 'soporte', 'soportes'],
      [modifiers, 'modificador', 'modificadores'],
      [negatives, 'parte negativa', 'partes negativas'],
      [unprinted, 'objeto apagado', 'objetos apagados'],
    ])}`,
  'file-nets-kept': keptNets,
  'file-nets-lost': ({ what }) => `${lostNets[what]}, así que se hicieron otras nuevas`,
  'file-nets-unused': ({ pieces }) =>
    `el archivo trae ${counted.templates(pieces)} ${choose(pieces, 'propia', 'propias')}; se hicieron otras nuevas; ` +
    `para ${choose(pieces, 'conservarla', 'conservarlas')}, elígelo al revisar el modelo (--nets file)`,
  'fold-nets-unused': ({ pieces }) =>
    `el archivo trae ${counted.templates(pieces)} ${choose(pieces, 'propia, que no se usó', 'propias, que no se usaron')}: su modelo plegado se desplegó de nuevo`,
  'parts-unused': ({ parts }) =>
    `se ${choose(parts, 'pidió', 'pidieron')} ${count(parts, 'parte', 'partes')}, pero las plantillas del archivo tienen las suyas, y esas se conservaron`,
  'pdo-unused': ({ hidden, texts, images }) =>
    `no se usa: ${kinds([
      [hidden, 'cuerpo apagado', 'cuerpos apagados'],
      [texts, 'texto en las hojas', 'textos en las hojas'],
      [images, 'imagen en las hojas', 'imágenes en las hojas'],
    ])}`,
  'posed-skins': ({ count: number }) =>
    `${count(number, 'malla con esqueleto está', 'mallas con esqueleto están')} en la postura con que empieza el archivo`,
  'unknown-extensions': ({ names }) =>
    `el archivo usa ${some(names)}, que aquí no se ${choose(names.length, 'conoce', 'conocen')}; puede faltar algo o verse distinto`,
  'unused-content': ({ animations, morphs, uvs, cameras, instances }) =>
    `no se usa: ${kinds([
      [animations, 'animación', 'animaciones'],
      [morphs, 'deformación', 'deformaciones'],
      [uvs, 'segundo juego de coordenadas de imagen', 'segundos juegos de coordenadas de imagen'],
      [cameras, 'cámara', 'cámaras'],
      [instances, 'grupo de copias', 'grupos de copias'],
    ])}`,
} satisfies Partial<Table>;
