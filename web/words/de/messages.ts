/** A German phrase for every message, which may be part of a line. */
import type { Messages, Table } from '../messages.js';
import { fileMessages } from './files.js';
import { all, choose, count, figure, fixed, parts, pieces, some } from './numbers.js';
import { optionFault } from './options.js';
import { paperMessages } from './paper.js';
import { projectMessages } from './projects.js';
import { readerMessages } from './readers.js';
import { repairMessages } from './repair.js';

const simplify = 'vereinfache das Modell auf weniger Flächen';

/** What a stage does, to be read after "beim", and what helps where memory ends in it. */
const stages = {
  read: [
    'Lesen und Reparieren des Modells',
    'vereinfache das Modell in dem Programm, das es gemacht hat',
  ],
  learn: ['Lernen aus Abwicklungen', simplify],
  cluster: ['Schneiden des Modells in Abschnitte', simplify],
  search: ['Suchen der Netze', simplify],
  compact: ['Schaffen von Platz für Laschen', simplify],
  paper: [
    'Verteilen der Teile auf Blätter',
    'wähle eine kleinere Größe, kleineres Papier oder weniger Flächen',
  ],
} as const;

const units = { mm: 'Millimeter', cm: 'Zentimeter', m: 'Meter', in: 'Zoll' } as const;
const sides = { height: 'die Höhe', width: 'die Breite', depth: 'die Tiefe' } as const;
const faces = (number: number): string => count(number, 'Fläche', 'Flächen');
const edges = (number: number): string => count(number, 'Kante', 'Kanten');

function badEdit(params: Messages['bad-edit']): string {
  switch (params.what) {
    case 'no-part-named':
      return 'eine Änderung muss einen Abschnitt nennen';
    case 'no-part':
      return `den Abschnitt ${figure(params.part)} gibt es nicht: Das Modell hat ${count(params.parts, 'Abschnitt', 'Abschnitte')}`;
    case 'twice':
      return `Abschnitt ${figure(params.part)} ist zweimal genannt: immer nur eine Änderung je Abschnitt`;
    case 'apart':
      return `${parts(params.parts)} berühren sich nicht, können also nicht einer werden`;
    case 'into':
      return (
        `${parts(params.parts)}: ${figure(params.into)} daraus zu machen geht nicht, möglich sind 1 bis ` +
        `${figure(params.most)}, einer je ebener Fläche`
      );
  }
}

function badOption(params: Messages['bad-option']): string {
  switch (params.what) {
    case 'height':
    case 'width':
    case 'depth':
      return `${sides[params.what]} muss über 0 und höchstens ${figure(params.most)} mm sein`;
    case 'scale':
      return `der Faktor muss über 0 und höchstens ${figure(params.most)} sein`;
    case 'paper':
      return `das Papier muss zwischen 0 und ${figure(params.most)} mm messen`;
    case 'pin-sheet':
      return `das Blatt eines festgehaltenen Teils muss unter den ersten ${figure(params.most)} sein`;
    case 'parts':
      return `die Zahl der Abschnitte muss auto oder mindestens ${figure(params.least)} sein`;
    case 'proxy':
      return `proxy muss ${figure(params.least)} oder mehr sein`;
    case 'faces':
      return `die Zahl der Flächen muss mindestens ${figure(params.least)} sein`;
    case 'margin':
      return `der Rand muss ${figure(params.least)} mm oder mehr sein, und weniger als die halbe kürzere Seite des Papiers`;
    case 'sheets':
      return `die Zahl der Blätter muss eine ganze Zahl von ${figure(params.least)} bis ${figure(params.most)} sein`;
    case 'flaps':
    case 'flap-height':
      return `die Höhe einer Lasche muss von ${figure(params.least)} bis ${figure(params.most)} mm sein`;
    case 'flap-angle':
      return `der Winkel der Laschen muss von ${figure(params.least)} bis ${figure(params.most)} Grad sein`;
    case 'runs':
    case 'clearance':
    case 'fill-holes':
      return `${params.what} muss von ${figure(params.least)} bis ${figure(params.most)} sein`;
    case 'repair':
      return `'${params.step}' ist ein Schritt der Reparatur, der sich nicht abschalten lässt`;
    case 'names-of-part':
      return 'jeder Abschnitt kann höchstens einen Namen haben';
    case 'pin-piece':
      return 'ein festgehaltenes Teil muss durch seinen Abschnitt und eine Fläche davon benannt sein';
    case 'pin-place':
      return 'der Ort eines festgehaltenen Teils muss eine endliche Zahl sein';
    case 'name-control':
      return 'der Name eines Abschnitts darf keine Steuerzeichen haben';
    case 'name-colon':
      return 'der Name eines Abschnitts darf keinen Doppelpunkt haben, denn der steht vor der Nummer einer Kante';
    case 'name-length':
      return 'der Name eines Abschnitts muss 1 bis 16 Zeichen haben, ohne Leerzeichen am Anfang und am Ende';
    case 'name-number':
      return 'der Name eines Abschnitts darf keine Zahl sein: Zahlen benennen Kanten';
    case 'same-name':
      return `zwei Abschnitte können nicht beide „${params.name}“ heißen`;
    case 'flap-edge':
      return `für die Kante von Ecke ${figure(params.from)} zu ${figure(params.to)} ist eine Lasche gewählt, aber das Modell hat sie nicht`;
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
    `in dieser Größe passt eine ebene Fläche von ${figure(face_width_mm, 0)} x ${figure(face_height_mm, 0)} mm nicht auf ein Blatt von ` +
    `${figure(width_mm, 3)} x ${figure(height_mm, 3)} mm: Sie würde bei ${Math.floor(100 * share)} % der Größe passen, ` +
    `oder auf Papier, das ${paper}-mal so groß ist`
  );
}

function locked(params: Messages['locked']): string {
  switch (params.what) {
    case 'fold':
      return 'diese Kante ist festgelegt: Sie wird nie geschnitten';
    case 'cut':
      return 'diese Kante ist festgelegt: Sie wird immer geschnitten';
    case 'faces':
      return 'eine festgelegte Falte hält die Flächen, wo sie sind';
    case 'loop':
      return 'der Ring lässt sich nicht anderswo öffnen: Seine Falten sind festgelegt';
    case 'parts':
      return `festgelegte Falten halten die Flächen zusammen: ${figure(params.parts)} Abschnitte lassen sich daraus nicht machen`;
  }
}

/** A time that is only estimated; nothing of one that nobody would mind. */
function roughTime(seconds: number): string {
  if (seconds < 12) return '';
  const time =
    seconds < 90
      ? `${Math.round(seconds / 5) * 5} Sekunden`
      : `${Math.round(seconds / 60)} Minuten`;
  return `Netze dafür dauern etwa ${time}, und `;
}

function partsRaised(params: Messages['parts-raised']): string {
  if (params.what === 'bodies') {
    const bodies = count(params.bodies, 'einzelnen Körper', 'einzelne Körper');
    return `das Modell hat ${bodies}, braucht also mindestens so viele Abschnitte`;
  }
  return (
    `in ${figure(params.parts)} Abschnitten käme es auf ${figure(params.pieces)} Teile, darum wurde es in ` +
    `${figure(params.instead)} Abschnitte geschnitten, jeder in einem Teil`
  );
}

function uncheckedPieces({ what, pieces: names }: Messages['unchecked-pieces']): string {
  const help = 'mehr Abschnitte oder weniger Flächen würden helfen';
  if (what === 'large') {
    return `alle Falten gleichmäßig zu drehen, faltet ${pieces(names)} nicht, und bei so vielen Flächen wurde kein anderer Weg gesucht; ${help}`;
  }
  const reasons = {
    off: 'die Suche danach ist ausgeschaltet',
    cancelled: 'der Lauf wurde vorher abgebrochen',
    kept: 'das frühere Ergebnis, das bleibt, hatte keinen',
    huge: `so viele Flächen dauern zu lange; ${help}`,
  };
  return `kein Weg, ${pieces(names)} zu falten, wurde gesucht: ${reasons[what]}`;
}

const mine = { height: 'Höhe', width: 'Breite', depth: 'Tiefe' } as const;

export const messages: Table = {
  ...fileMessages,
  ...repairMessages,
  ...paperMessages,
  ...projectMessages,
  ...readerMessages,

  'bad-edit': badEdit,
  'bad-margin': () =>
    'die Ränder lassen vom Blatt nichts übrig: Papier und Rand passen nicht zusammen',
  'bad-option': badOption,
  'bad-pin': (params) =>
    params.what === 'outside'
      ? `Teil ${params.piece} ist so festgehalten, dass es über den druckbaren Bereich von Blatt ${figure(params.sheet)} ragt`
      : `die Teile ${params.pieces.join(' und ')} sind auf Blatt ${figure(params.sheet)} übereinander festgehalten`,
  'bad-start': () => 'das frühere Ergebnis gehört nicht zu diesem Modell',
  'face-too-large': faceTooLarge,
  internal: ({ what, detail }) => `interner Fehler beim ${stages[what][0]}: ${detail}`,
  'no-depth': () => 'das Modell hat keine Tiefe, die sich ändern ließe',
  'no-height': () => 'das Modell hat keine Höhe, die sich ändern ließe',
  'no-width': () => 'das Modell hat keine Breite, die sich ändern ließe',
  'out-of-memory': ({ what }) =>
    what === 'file'
      ? 'der Speicher reicht nicht für die Datei des Modells'
      : `der Speicher reicht nicht zum ${stages[what].join(': ')}`,
  'too-many-faces': ({ faces: number, most, proposed }) =>
    `das Modell hat ${figure(number)} ebene Flächen, und Netze für mehr als ${figure(most)} würden Stunden dauern und wären viel zu klein zum Falten: --faces ${proposed} macht ein einfacheres Modell, das sich falten lässt`,
  'too-few-sheets': () => 'die Teile gehen in keiner Größe auf so wenige Blätter',

  'edit-place-gone': ({ what }) =>
    ({
      edge: 'eine solche Kante gibt es dort nicht mehr',
      faces: 'solche Flächen gibt es dort nicht mehr',
      part: 'einen solchen Abschnitt gibt es dort nicht mehr',
      piece: 'ein solches Teil gibt es dort nicht mehr',
    })[what],
  'already-cut': () => 'diese Kante ist schon geschnitten',
  'already-joined': () => 'diese Kante ist schon eine Falte',
  locked,
  'inside-panel': () => 'diese Kante liegt in einer ebenen Fläche, die ganz bleibt',
  'no-edge': ({ from, to }) =>
    `das Modell hat keine Kante zwischen den Ecken ${figure(from)} und ${figure(to)}`,
  'no-face': (params) =>
    params.what === 'none'
      ? 'keine Fläche wurde genannt'
      : `das Modell hat die Flächen von 0 bis ${figure(params.most)}`,
  'no-net': () => 'eine Fläche neben dieser Kante hat noch kein Netz',
  'no-part': ({ part, parts: number }) =>
    `den Abschnitt ${figure(part)} gibt es nicht: Das Modell hat ${figure(number)}`,
  'not-in-loop': () => 'dort zu schneiden, würde den Ring nicht öffnen',
  'not-touching': () => 'die Flächen berühren diesen Abschnitt nicht',
  overlap: ({ what }) =>
    what === 'pieces'
      ? 'die zwei Teile würden sich dort überlappen'
      : 'Flächen des Teils würden sich überlappen, wo immer es sich stattdessen öffnet',
  'would-fall-apart': ({ what, part }) =>
    `ohne ${what === 'fold' ? 'diese Falte' : 'diese Flächen'} fiele Abschnitt ${figure(part)} auseinander`,

  'files-ignored': ({ files }) =>
    `${count(files.length, 'andere Datei wurde', 'andere Dateien wurden')} nicht gebraucht: ${some(files)}`,
  'faces-above-wish': ({ faces: number }) =>
    `das Vereinfachen hörte bei ${faces(number)} auf: Weniger würden die Oberfläche zerreißen`,
  joints: ({ what, count: number }) =>
    `${edges(number)} ${choose(number, 'wird', 'werden')} auf Flächen geklebt, die dort nicht ` +
    `weitergehen${what === 'numbered' ? ': Such dort dieselbe Nummer' : ''}`,
  'joints-lost': ({ count: number }) =>
    `${edges(number)}, die auf anderen Flächen ${choose(number, 'stand', 'standen')}, ` +
    `${choose(number, 'löste', 'lösten')} sich beim Vereinfachen: Klebe nach Augenmaß`,
  'large-model': ({ faces: number, seconds, proposed }) =>
    `das Modell hat ${faces(number)}: ${roughTime(seconds)}die meisten davon sind zu klein ` +
    `zum Falten; Papiermodelle haben ein paar hundert (--faces ${proposed} macht ein einfacheres Modell)`,
  'colour-numbers': () =>
    'die Datei gibt ihren Flächen Zahlen statt Farben und sagt nicht, welche Farben das sind: Sie werden nicht gedruckt',
  'meets-itself': ({ part }) =>
    `Abschnitt ${figure(part)} hat Flächen, die im Modell durcheinander gehen, also lässt er sich nicht ohne Zusammenstöße falten`,
  'no-motion': ({ part }) =>
    `kein Weg wurde gefunden, Abschnitt ${figure(part)} in einem Zug zu falten, ohne dass Flächen zusammenstoßen`,
  'part-split': ({ what, part, pieces: number }) =>
    `Abschnitt ${figure(part)} ${what === 'no-motion' ? 'lässt sich in einem Teil nicht falten' : 'hat kein Netz in einem Teil'} und wurde ` +
    `zu ${figure(number)} Teilen`,
  'parts-lowered': ({ panels }) =>
    `das Modell hat nur ${count(panels, 'ebene Fläche', 'ebene Flächen')}, kann also nicht mehr Abschnitte haben`,
  'parts-raised': partsRaised,
  'pin-lost': ({ count: number }) =>
    number === 1
      ? '1 festgehaltenes Teil ist nicht mehr da, wie es war, und wurde neu gelegt'
      : `${figure(number)} festgehaltene Teile sind nicht mehr da, wie sie waren, und wurden neu gelegt`,
  'small-bodies': ({ count: number, limit_mm }) =>
    `${figure(number)} Körper des Modells ${choose(number, 'ist', 'sind')} kleiner als ${figure(limit_mm)} mm und ` +
    `${choose(number, 'fällt', 'fallen')} weg`,
  'smaller-saves-sheets': ({ what, size_mm, instead_mm, sheets, of }) =>
    `mit einer ${mine[what]} von ${figure(size_mm)} mm statt ${figure(Math.round(instead_mm))} sollte es auf ` +
    `${count(sheets, 'Blatt', 'Blätter')} statt ${figure(of)} gehen`,
  'sheet-split': ({ part, pieces: number }) =>
    `Abschnitt ${figure(part)} ist zu groß für das Blatt und wurde in ${figure(number)} Teile geschnitten`,
  'run-stopped': () =>
    'die Suche wurde vor ihrem Ende angehalten, und was bis dahin gefunden war, ist hier; wickle neu ab, damit sie zu Ende läuft',
  'unchecked-pieces': uncheckedPieces,
  'unit-guessed': ({ unit }) =>
    `die Einheit des Modells ist nicht bekannt; angenommen wurden ${units[unit]}`,
  'up-guessed': () =>
    'die Datei sagt nicht, was oben ist; genommen wurde die z-Achse, wie in den meisten Dateien dieses Formats',
  'weak-necks': ({ pieces: names }) =>
    'Falten unter 5 mm halten auf beiden Seiten viele Flächen und können reißen: Verstärke sie hinten mit Klebeband; ' +
    pieces(names),

  'engine-died': ({ reason, times }) =>
    times === undefined
      ? `Das Rechenwerk hörte unerwartet auf: ${reason}`
      : `Das Rechenwerk hörte ${figure(times)}-mal unerwartet bei derselben Aufgabe auf: ${reason}`,
  overtaken: () => 'inzwischen wurde ein anderer Schritt zurückgenommen oder wiederholt',
  'no-piece': ({ piece, pieces: number }) =>
    `das Teil ${figure(piece)} gibt es nicht: Es gibt ${figure(number)}`,
  'not-pinned': ({ piece }) => `Teil ${figure(piece)} ist nicht festgehalten`,
  'not-together': () =>
    'nur Änderungen an Laschen allein, oder solche, die Abschnitte teilen und vereinen, lassen sich auf einmal machen',
  'no-legend': () => 'kein Blatt hat Platz für die Zeichenerklärung',
  'beyond-page': ({ by_mm, margin_mm }) =>
    `für diesen Drucker korrigiert, ragen Linien ${fixed(by_mm, 1)} mm über den Rand der Seite; mit einem Rand von ${figure(margin_mm)} mm (--margin ${margin_mm}) bleiben sie darauf`,
  'missing-glyphs': ({ letters }) =>
    `keine Schrift hat ${letters.join(' ')}: Dafür wird ein Kästchen gedruckt`,
  'fonts-not-loaded': () =>
    'die Schriften für manche Buchstaben ließen sich nicht laden: Sie sehen so aus, wie die Schriften deines Geräts sie haben',
  'marks-not-free': ({ pieces: names, margin_mm }) =>
    'die Maschine sucht ihre Marken dort, wo etwas geschnitten wird: ' +
    `Ein Rand von ${figure(margin_mm)} mm hält sie frei; ${pieces(names)}`,
  'cricut-area': ({ sheets, width_mm, height_mm, margin_mm }) =>
    `Cricut druckt und schneidet von diesem Papier höchstens ${Math.floor(width_mm)} x ${Math.floor(height_mm)} mm, und ` +
    `${choose(sheets.length, 'Blatt', 'Blätter')} ${all(sheets.map((sheet) => figure(sheet)))} ` +
    `${choose(sheets.length, 'braucht', 'brauchen')} mehr: Schneide ohne zu drucken, oder wähle einen Rand von ${figure(margin_mm)} mm`,
};
