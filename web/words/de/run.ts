/** What is said in German while a model is unfolded, and of what comes of it. */
import type { Words } from '../words.js';
import { choose, count, figure, fixed } from './numbers.js';

const parts = (number: number): string => count(number, 'Abschnitt', 'Abschnitte');
const pieces = (number: number): string => count(number, 'Teil', 'Teile');
const seams = (number: number): string => count(number, 'Naht', 'Nähte');
/** "auf 3 Blättern A4" */
const onSheets = (number: number, paper: string): string =>
  `auf ${count(number, 'Blatt', 'Blättern')} ${paper}`;
/** "von 3 Nähten" */
const ofSeams = (number: number): string => `von ${count(number, 'Naht', 'Nähten')}`;

export const run: Words['run'] = {
  stages: {
    read: 'Modell wird gelesen',
    learn: 'Lernt, welche Flächen sich gut zusammen ausbreiten lassen',
    cluster: 'Abschnitte werden gewählt',
    search: 'Abschnitte werden flach ausgebreitet',
    compact: 'Platz für Laschen wird geschaffen',
    paper: 'Teile werden auf Blätter gelegt',
  },
  stageLines: {
    read: 'liest das Modell',
    learn: 'lernt aus Abwicklungen',
    cluster: 'schneidet in Abschnitte',
    search: 'sucht Netze',
    compact: 'schafft Platz für Laschen',
    paper: 'legt auf Blätter',
  },
  detailed: (stage, detail) => `${stage}: ${detail}`,
  learned: (runs, of) => `${figure(runs)} von ${figure(of)} Abwicklungen probiert`,
  partsDone: (done, all) => `${figure(done)} von ${count(all, 'Abschnitt', 'Abschnitten')} fertig`,
  overlapsLeft: (overlaps) => `noch ${count(overlaps, 'Überlappung', 'Überlappungen')}`,
  minutesLeft: (minutes) => `noch etwa ${figure(minutes)} Minuten`,
  secondsLeft: (seconds) => `noch etwa ${figure(seconds)} Sekunden`,
  goingBack: 'Geht zurück.',
  stopping: 'Legt die fertigen Teile auf Blätter.',

  done: (lead) => `Fertig: ${lead}`,
  stopped: (lead) => `Angehalten. ${lead}`,
  undone: (lead) => `Rückgängig gemacht: ${lead}`,
  madeAgain: (lead) => `Wiederholt: ${lead}`,
  hold: (why) => `Sieh dir das Modell an. ${why}`,
  named: (name) => `Heißt jetzt ${name}.`,
  nameGone: 'Der Name ist weg.',
  editCancelled: 'Abgebrochen. Alles ist, wie es war.',
  unfoldAgain: 'Neu abwickeln',

  farewells: { cancelled: 'Abgebrochen.', empty: 'Angehalten.' },
  notes: {
    cancelled: 'Abgebrochen. So weit war es; nichts davon bleibt.',
    empty: 'Angehalten. So weit war es.',
    failed: 'So weit war es.',
    undrawn: 'Die Netze sind gefunden, aber nicht gezeichnet.',
  },
  nextSteps: {
    file: 'Wähle ein anderes Modell, oder repariere dieses und versuche es noch einmal.',
    job: 'Ändere die Einstellungen und versuche es noch einmal, oder wähle ein anderes Modell.',
    crash:
      'Sonst ist nichts verloren, und der nächste Lauf beginnt von vorn. Vielleicht klappt es mit einem kleineren Modell.',
  },
  nothingToUse: [
    'Noch gibt es nichts, was du nehmen kannst',
    'Als du die Suche angehalten hast, hatte kein Abschnitt ein Netz: Das letzte wurde gerade geändert. Lass sie beim nächsten Mal etwas länger laufen.',
  ],
  notUnfolded: (model) => `„${model}“ ließ sich nicht abwickeln`,
  stillThere: (model) => `Unten siehst du noch das Ergebnis von „${model}“.`,
  notDrawn: (model) => `Die Blätter von „${model}“ ließen sich nicht zeichnen`,
  notWritten: (format) => `Die ${format}-Datei ließ sich nicht schreiben`,
  projectNotWritten: 'Die Projektdatei ließ sich nicht schreiben',
  resultIsHere: 'Das Ergebnis ist noch da.',
  notPrinted: 'Die Seiten ließen sich nicht drucken',
  onceMore: 'Versuche es noch einmal.',
  nothingChanged: 'Nichts wurde geändert',
  nothingUnfolded: 'Nichts wurde abgewickelt',
  noBrowser: 'In diesem Browser läuft Foldwright nicht',
  browserLacks:
    'Diesem Browser fehlen Modul-Worker oder WebAssembly mit SIMD und Ausnahmen, die das Abwickeln ' +
    'braucht. Chrome und Edge haben sie seit Version 95, Firefox seit 114, Safari seit 16.4.',
};

export const result: Words['result'] = {
  onePiece: (sheets, paper) => `Alles in einem Teil, ${onSheets(sheets, paper)}.`,
  eachInOne: (all, sheets, paper) =>
    `${parts(all)}, jeder in einem Teil, ${onSheets(sheets, paper)}.`,
  inPieces: (all, number, sheets, paper) =>
    `${parts(all)} in ${count(number, 'Teil', 'Teilen')} ${onSheets(sheets, paper)}.`,
  withHoles: (p) => {
    const all = count(p.parts, 'Abschnitt', 'Abschnitten');
    const whole =
      p.finished === 0
        ? `Keiner von ${all} ist ganz`
        : `Nur ${figure(p.finished)} von ${all} ${choose(p.finished, 'ist', 'sind')} ganz`;
    const missing = p.parts - p.finished;
    const others =
      missing === 1
        ? 'Der andere Abschnitt fehlt'
        : `Die anderen ${figure(missing)} Abschnitte fehlen`;
    return (
      `${whole}: ${pieces(p.pieces)} ${onSheets(p.sheets, p.paper)}. ` +
      `${others}, das Modell hätte also Löcher. Wickle es noch einmal ab, um alle zu bekommen.`
    );
  },
  facts: {
    pieces: 'Teile',
    sheets: 'Blätter',
    size: 'Fertige Größe',
    smallest: 'Kleinstes Teil',
    glue: 'Zu kleben',
    flaps: 'Laschen',
    numbers: 'Kantennummern',
    scale: 'Maßstab',
    paper: 'Papier genutzt',
    triangles: 'Dreiecke',
    time: 'Berechnet in',
  },
  none: 'keine',
  smallest: (name, width, height) => `${name}, ${figure(width)} × ${figure(height)} mm`,
  glue: (metres, number) => `${fixed(metres, 1)} m an ${count(number, 'Naht', 'Nähten')}`,
  flaps: (p) => {
    const words: string[] = [];
    if (p.wanted > 0) words.push(`an ${figure(p.flaps)} ${ofSeams(p.wanted)}`);
    if (p.shrunk > 0) words.push(`${figure(p.shrunk)} davon schmal`);
    if (p.strips > 0) words.push(count(p.strips, 'loser Streifen', 'lose Streifen'));
    if (p.taped > 0) words.push(`${seams(p.taped)} mit Klebeband`);
    return words.join(', ');
  },
  numbers: (printed, all) => `an ${figure(printed)} ${ofSeams(all)}`,
  scale: (mm) => `1 Einheit ist ${figure(mm)} mm`,
  percent: (percent) => `${figure(percent)} %`,
  seconds: (seconds, digits) => `${fixed(seconds, digits)} s`,
  minutes: (minutes, seconds) => `${figure(minutes)} min ${figure(seconds)} s`,
  repaired: 'Vor dem Abwickeln repariert',
  worthKnowing: 'Gut zu wissen',
  sheet: (sheet, of) => `Blatt ${figure(sheet)} von ${figure(of)}`,
  caption: (sheet, of, names) =>
    `Blatt ${figure(sheet)} von ${figure(of)}: ${choose(names.length, 'Teil', 'Teile')} ${names.join(', ')}`,
  forModel: (percent) => `${figure(percent)} % für das Modell`,
};

export const pictures: Words['pictures'] = {
  matrixToCome: 'jedes Paar von Flächen ist ein Punkt',
  nothingLearned: 'für diese Abschnitte musste nichts gelernt werden',
  blocks: 'jeder Rahmen ist ein Abschnitt',
  darker: 'dunkler: öfter zusammen',
  netToCome: 'kommt, wenn die Abschnitte gewählt sind',
  netBegins: 'beginnt gleich',
  generation: (part, generation, overlaps) =>
    `Abschnitt ${figure(part)}, Generation ${figure(generation)}: ${count(overlaps, 'Überlappung', 'Überlappungen')}`,
  netDone: (part) => `Abschnitt ${figure(part)}, ohne Überlappungen`,
  couldBePrinted: (sheets) =>
    `${sheets === 1 ? 'dieses Blatt könnte' : `diese ${count(sheets, 'Blatt', 'Blätter')} könnten`} schon gedruckt werden; die Netze werden noch leichter zu bauen`,
  netsToCome: 'jedes kommt hierher, sobald es flach liegt',
  netsFound: (nets) =>
    `bisher ${count(nets, 'Netz', 'Netze')} gefunden; Buchstaben und Blätter kommen am Schluss`,
  noWebGl: 'Dieser Browser zeigt nichts in 3D, weil er kein WebGL 2 hat. Alles andere geht.',
  broken: 'Die 3D-Ansicht geht hier nicht. Alles andere schon.',
};
