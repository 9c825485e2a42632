/** What the cover and the pages with the steps say in German. */
import type { BuildingWords, EdgeList } from '../building.js';
import { all, count, figure } from './numbers.js';

const views = {
  'front-left': 'von vorn und links gesehen',
  'back-right': 'von hinten und rechts gesehen',
  'front-right': 'von vorn und rechts gesehen',
  'back-left': 'von hinten und links gesehen',
  above: 'von oben gesehen',
  below: 'von unten gesehen',
} as const;

const marks = {
  'close-first': 'schließen: Anfang',
  'close-last': 'schließen: letzte Kante',
  'glue-first': 'ankleben: Anfang',
  'glue-last': 'ankleben: letzte Kante',
  valley: 'Talfalte',
  border: 'wird an diese Farbe geklebt',
} as const;

const folds = { mountain: 'Bergfalte', valley: 'Talfalte' } as const;
const mountainFolds = (number: number): string =>
  number === 0 ? 'keine Bergfalten' : count(number, 'Bergfalte', 'Bergfalten');
const valleyFolds = (number: number): string =>
  number === 0 ? 'keine Talfalten' : count(number, 'Talfalte', 'Talfalten');

/** "etwa 40 Minuten", "etwa 3½ Stunden": nobody works to the minute. */
function duration({ seconds }: { seconds: number }): string {
  const minutes = seconds / 60;
  if (minutes < 57.5) return `etwa ${figure(Math.max(5, 5 * Math.round(minutes / 5)))} Minuten`;
  const halves = Math.round(minutes / 30);
  if (halves >= 20) return `etwa ${figure(Math.round(minutes / 60))} Stunden`;
  const whole = Math.floor(halves / 2);
  return halves % 2 === 1
    ? `etwa ${figure(whole)}½ Stunden`
    : `etwa ${count(whole, 'Stunde', 'Stunden')}`;
}

function withoutNumber({ edges, unnumbered }: EdgeList): string {
  if (unnumbered === 0) return '';
  if (unnumbered === edges) {
    return edges === 1 ? 'einer Kante ohne Nummer' : `${figure(edges)} Kanten ohne Nummer`;
  }
  return `und ${count(unnumbered, 'Kante', 'Kanten')} ohne Nummer`;
}

function startAndEnd({ edges, first, last }: EdgeList): string {
  if (edges < 2 || first === null) return '.';
  return last === null || last === first
    ? `. Beginne bei ${first}.`
    : `. Beginne bei ${first}; ${last} kommt zuletzt.`;
}

function close(list: EdgeList): string {
  const runs = [list.runs.join(', '), withoutNumber(list)].filter((text) => text !== '').join(' ');
  return `Schließe es entlang von ${runs}${startAndEnd(list)}`;
}

function glue(list: Parameters<BuildingWords['glue']>[0]): string {
  const groups = list.groups.map(({ name, runs }) =>
    runs.length > 0 ? `${name} entlang von ${runs.join(', ')}` : name,
  );
  const rest = withoutNumber(list);
  const along = list.unnumbered === list.edges ? ` entlang von ${rest}` : rest && ` ${rest}`;
  return `Klebe es an ${groups.join(', dann an ')}${along}${startAndEnd(list)}`;
}

function fold({ folds: number, crease, turn }: Parameters<BuildingWords['fold']>[0]): string {
  if (number === 0) return 'Es hat keine Falten.';
  const own = folds[crease];
  if (turn === 0) {
    return number === 1
      ? `Falte seine eine Falte als ${own}.`
      : `Falte alle seine ${figure(number)} Falten als ${own}n.`;
  }
  const other = folds[crease === 'mountain' ? 'valley' : 'mountain'];
  const others = turn === 1 ? `eine ist eine ${other}` : `${figure(turn)} sind ${other}n`;
  return `Falte seine ${figure(number)} Falten: ${others}, alle anderen sind ${own}n.`;
}

export const building: BuildingWords = {
  pageNote: ({ page, pages }) =>
    `Bauanleitung, Seite ${figure(page)} von ${figure(pages)} · zum Ansehen, nicht zum Schneiden`,
  view: ({ name }) => views[name],
  sizeLabel: () => 'Fertige Größe',
  size: ({ width, height, depth }) => `${width} mm breit, ${height} mm hoch, ${depth} mm tief`,
  amountLabel: () => 'Auszuschneiden',
  amount: ({ pieces, sheets, width, height }) =>
    `${count(pieces, 'Teil', 'Teile')} auf ${count(sheets, 'Blatt', 'Blättern')} von ${width} × ${height} mm`,
  foldsLabel: () => 'Zu falten',
  folds: ({ mountains, valleys }) => `${mountainFolds(mountains)}, ${valleyFolds(valleys)}`,
  seamsLabel: () => 'Zu verbinden',
  seams: ({ seams }) => count(seams, 'Naht', 'Nähte'),
  gluedLabel: () => 'Zeit mit Kleber',
  tapedLabel: () => 'Zeit mit Klebeband',
  duration,
  mountain: () => 'Bergfalte: wie ein Dach, die bedruckte Seite ist außen',
  valley: () => 'Talfalte: wie ein offenes Buch, die bedruckte Seite ist innen',
  valleyPieces: ({ names, pieces, all: isAll }) => {
    if (pieces === 0) return 'Alle Falten sind Bergfalten.';
    if (isAll && pieces > 1) return 'Alle Teile haben Talfalten: Die Schritte zeigen sie in Blau.';
    if (isAll) return 'Die Schritte zeigen die Talfalten in Blau.';
    const where = names.length > 0 ? all(names) : `${figure(pieces)} der Teile`;
    return `Talfalten sind nur auf ${where}: Die Schritte zeigen sie in Blau.`;
  },
  howTitle: () => 'So baust du es',
  how: () => [
    'Drucke die Blätter mit den Teilen mit 100 % auf dickes Papier (160 bis 200 g/m²). Für diese Seiten reicht dünnes Papier.',
    'Schneide entlang der durchgezogenen Linien. Zieh alle Falten mit einem leeren Stift am Lineal nach, dann falte.',
    'Kanten mit derselben Nummer gehören zusammen. Geh Schritt für Schritt vor; lass den Kleber vor dem nächsten Schritt trocknen.',
  ],
  piecesTitle: () => 'Die Teile und wohin sie gehören',
  sheet: ({ sheet }) => `auf Blatt ${figure(sheet)}`,
  faces: ({ faces, flaps }) =>
    `${count(faces, 'Fläche', 'Flächen')}, ${count(flaps, 'Lasche', 'Laschen')}`,
  pieceFolds: ({ folds: number, valleys }) => {
    if (number === 0) return 'keine Falten';
    const told = count(number, 'Falte', 'Falten');
    if (valleys === 0) return `${told}, keine Talfalte`;
    return valleys === number
      ? `${told}, alle Talfalten`
      : `${told}, ${figure(valleys)} davon ${valleys === 1 ? 'eine Talfalte' : 'Talfalten'}`;
  },
  hidden: () => 'hinter anderen: gezeichnet, als wären die aus Glas',
  strips: ({ runs, strips }) =>
    `Neben den Teilen ${strips === 1 ? 'gibt es einen losen Streifen' : `gibt es ${figure(strips)} lose Streifen`} ` +
    `Papier, hinter die Kanten ${runs.join(', ')} zu kleben.`,
  stepsTitle: () => 'Schritt für Schritt',
  marks: ({ mark }) => marks[mark],
  stepTitle: ({ step, name }) => `Schritt ${figure(step)}: Teil ${name}`,
  fold,
  close,
  glue,
  apart: () =>
    'Keine Kante davon wird an die Teile davor geklebt: Setz es dorthin, wo das Bild es zeigt. Wenn noch Nummern übrig sind, ' +
    'such dort dieselben.',
  finish: ({ last }) =>
    last === null
      ? 'Das war die letzte Kante: Das Modell ist fertig.'
      : `${last} ist die allerletzte Kante: Drück sie von außen an, bis sie hält.`,
};
