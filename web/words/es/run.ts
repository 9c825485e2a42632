/** What is said in Spanish while a model is unfolded, and of what comes of it. */
import type { Words } from '../words.js';
import { choose, count, counted, figure, fixed } from './numbers.js';

/** "en 3 hojas de A4" */
const onSheets = (number: number, paper: string): string =>
  `en ${counted.sheets(number)} de ${paper}`;

export const run: Words['run'] = {
  stages: {
    read: 'Leyendo el modelo',
    learn: 'Aprendiendo qué caras se despliegan bien juntas',
    cluster: 'Eligiendo las partes',
    search: 'Extendiendo las partes en plano',
    compact: 'Haciendo sitio para las pestañas',
    paper: 'Colocando las piezas en hojas',
  },
  stageLines: {
    read: 'leyendo el modelo',
    learn: 'aprendiendo de los despliegues',
    cluster: 'cortando en partes',
    search: 'buscando plantillas',
    compact: 'haciendo sitio para pestañas',
    paper: 'colocando en hojas',
  },
  detailed: (stage, detail) => `${stage}: ${detail}`,
  learned: (runs, of) => `${figure(runs)} de ${figure(of)} despliegues probados`,
  partsDone: (done, parts) => `${figure(done)} de ${count(parts, 'parte lista', 'partes listas')}`,
  overlapsLeft: (overlaps) =>
    `${choose(overlaps, 'queda', 'quedan')} ${counted.overlaps(overlaps)}`,
  minutesLeft: (minutes) => `quedan unos ${figure(minutes)} minutos`,
  secondsLeft: (seconds) => `quedan unos ${figure(seconds)} segundos`,
  goingBack: 'Volviendo atrás.',
  stopping: 'Colocando en hojas las piezas terminadas.',

  done: (lead) => `Listo: ${lead}`,
  stopped: (lead) => `Parado. ${lead}`,
  undone: (lead) => `Deshecho: ${lead}`,
  madeAgain: (lead) => `Rehecho: ${lead}`,
  hold: (why) => `Revisa el modelo. ${why}`,
  named: (name) => `Ahora se llama ${name}.`,
  nameGone: 'El nombre se ha quitado.',
  editCancelled: 'Cancelado. Todo está como estaba.',
  unfoldAgain: 'Volver a desplegar',

  farewells: { cancelled: 'Cancelado.', empty: 'Parado.' },
  notes: {
    cancelled: 'Cancelado. Hasta aquí llegó; no se guarda nada.',
    empty: 'Parado. Hasta aquí llegó.',
    failed: 'Hasta aquí llegó.',
    undrawn: 'Las plantillas se encontraron, pero no se dibujaron.',
  },
  nextSteps: {
    file: 'Elige otro modelo, o repara este e inténtalo otra vez.',
    job: 'Cambia los ajustes e inténtalo otra vez, o elige otro modelo.',
    crash:
      'No se ha perdido nada más, y la próxima vez se empieza de nuevo. Con un modelo más pequeño puede que funcione.',
  },
  nothingToUse: [
    'Todavía no hay nada que usar',
    'Cuando se paró la búsqueda, ninguna parte tenía plantilla: la última se estaba cambiando otra vez. La próxima vez, déjala un poco más.',
  ],
  notUnfolded: (model) => `«${model}» no se pudo desplegar`,
  stillThere: (model) => `Lo de abajo sigue siendo el resultado de «${model}».`,
  notDrawn: (model) => `No se pudieron dibujar las hojas de «${model}»`,
  notWritten: (format) => `No se pudo escribir el archivo ${format}`,
  projectNotWritten: 'No se pudo escribir el archivo del proyecto',
  resultIsHere: 'El resultado sigue aquí.',
  notPrinted: 'No se pudieron imprimir las páginas',
  onceMore: 'Inténtalo otra vez.',
  nothingChanged: 'No se ha cambiado nada',
  nothingUnfolded: 'No se ha desplegado nada',
  noBrowser: 'Foldwright no funciona en este navegador',
  browserLacks:
    'A este navegador le faltan los workers de módulo o WebAssembly con SIMD y excepciones, que hacen falta para ' +
    'desplegar. Chrome y Edge los tienen desde la versión 95, Firefox desde la 114, Safari desde la 16.4.',
};

export const result: Words['result'] = {
  onePiece: (sheets, paper) => `Todo en una pieza, ${onSheets(sheets, paper)}.`,
  eachInOne: (parts, sheets, paper) =>
    `${counted.parts(parts)}, cada una en una pieza, ${onSheets(sheets, paper)}.`,
  inPieces: (parts, pieces, sheets, paper) =>
    `${counted.parts(parts)} en ${counted.pieces(pieces)} ${onSheets(sheets, paper)}.`,
  withHoles: (p) => {
    const parts = counted.parts(p.parts);
    const whole =
      p.finished === 0
        ? `Ninguna de ${parts} está entera`
        : `Solo ${figure(p.finished)} de ${parts} ${choose(p.finished, 'está entera', 'están enteras')}`;
    const missing = p.parts - p.finished;
    const others =
      missing === 1 ? 'Falta la otra parte' : `Faltan las otras ${figure(missing)} partes`;
    return (
      `${whole}: ${counted.pieces(p.pieces)} ${onSheets(p.sheets, p.paper)}. ` +
      `${others}, así que el modelo tendrá agujeros. Vuelve a desplegarlo para tenerlas todas.`
    );
  },
  facts: {
    pieces: 'Piezas',
    sheets: 'Hojas',
    size: 'Tamaño final',
    smallest: 'Pieza más pequeña',
    glue: 'Para pegar',
    flaps: 'Pestañas',
    numbers: 'Números de arista',
    scale: 'Escala',
    paper: 'Papel usado',
    triangles: 'Triángulos',
    time: 'Calculado en',
  },
  none: 'no hay',
  smallest: (name, width, height) => `${name}, ${figure(width)} × ${figure(height)} mm`,
  glue: (metres, seams) => `${fixed(metres, 1)} m en ${counted.seams(seams)}`,
  flaps: (p) => {
    const words: string[] = [];
    if (p.wanted > 0) words.push(`en ${figure(p.flaps)} de ${counted.seams(p.wanted)}`);
    if (p.shrunk > 0) {
      words.push(`${figure(p.shrunk)} de ellas ${choose(p.shrunk, 'estrecha', 'estrechas')}`);
    }
    if (p.strips > 0) words.push(count(p.strips, 'tira suelta', 'tiras sueltas'));
    if (p.taped > 0) words.push(`${figure(p.taped)} con cinta adhesiva`);
    return words.join(', ');
  },
  numbers: (printed, seams) => `en ${figure(printed)} de ${counted.seams(seams)}`,
  scale: (mm) => `1 unidad son ${figure(mm)} mm`,
  percent: (percent) => `${figure(percent)} %`,
  seconds: (seconds, digits) => `${fixed(seconds, digits)} s`,
  minutes: (minutes, seconds) => `${figure(minutes)} min ${figure(seconds)} s`,
  repaired: 'Reparado antes de desplegar',
  worthKnowing: 'Conviene saber',
  sheet: (sheet, of) => `Hoja ${figure(sheet)} de ${figure(of)}`,
  caption: (sheet, of, names) =>
    `Hoja ${figure(sheet)} de ${figure(of)}: ${choose(names.length, 'pieza', 'piezas')} ${names.join(', ')}`,
  forModel: (percent) => `${figure(percent)} % para el modelo`,
};

export const pictures: Words['pictures'] = {
  matrixToCome: 'cada par de caras es un punto',
  nothingLearned: 'para estas partes no hubo que aprender nada',
  blocks: 'cada marco es una parte',
  darker: 'más oscuro: más veces juntas',
  netToCome: 'viene cuando se hayan elegido las partes',
  netBegins: 'empieza enseguida',
  generation: (part, generation, overlaps) =>
    `parte ${figure(part)}, generación ${figure(generation)}: ${counted.overlaps(overlaps)}`,
  netDone: (part) => `parte ${figure(part)}, sin solapes`,
  couldBePrinted: (sheets) =>
    `${sheets === 1 ? 'esta hoja ya se puede' : `estas ${count(sheets, 'hoja', 'hojas')} ya se pueden`} imprimir; las plantillas se están haciendo más fáciles de montar`,
  netsToCome: 'cada una aparece aquí en cuanto queda plana',
  netsFound: (nets) =>
    `${count(nets, 'plantilla encontrada', 'plantillas encontradas')} hasta ahora; las letras y las hojas vienen al final`,
  noWebGl: 'Este navegador no dibuja vistas 3D porque no tiene WebGL 2. Todo lo demás funciona.',
  broken: 'La vista 3D no funciona aquí. Todo lo demás, sí.',
};
