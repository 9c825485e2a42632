/** What is said in German of a model that is chosen and looked at before it is unfolded. */
import type { Words } from '../words.js';
import { choose, count, figure, large, rounded, some } from './numbers.js';
import { excess } from './readers.js';

const levels = { easy: 'Leicht', medium: 'Mittel', hard: 'Schwer' } as const;

export const choice: Words['choice'] = {
  opening: (files) => `Wird geöffnet: ${some(files)}`,
  chosen: (files) => `Gewählt: ${some(files)}`,
  fileTooLarge: (file, fault) =>
    `„${file}“ ist zu groß: Die Datei hat ${excess(fault)}. Speichere sie mit weniger Flächen oder in einem binären Format.`,
  tooMuch: (fault) =>
    `Das ist zu viel: Es sind ${excess(fault)}. Wähle ein Modell und was dazugehört.`,
  notLoaded: (file) => `„${file}“ lässt sich nicht laden.`,
  notLetIn: (file) =>
    `„${file}“ lässt sich nicht laden: Die Datei liegt auf einer anderen Website, und Browser holen sie nur, wenn beide Websites es erlauben. Speichere sie auf deinem Gerät und zieh sie hierher.`,
  unreadable: (file) =>
    `„${file}“ lässt sich nicht lesen: Es ist ein Ordner, wurde verschoben oder darf nicht geöffnet werden.`,
  unreadableDrop: (file) =>
    `„${file}“ lässt sich nicht lesen: Die Datei wurde verschoben oder darf nicht geöffnet werden.`,
  noFile:
    'Das war keine Datei. Wähle eine Datei in GLB, OBJ, STL, 3MF, PLY, OFF, PDO oder FOLD, oder ein ZIP mit einer.',
  empty: (file) => `„${file}“ ist leer: Es gibt darin nichts abzuwickeln.`,
  noSamples: 'Die Beispiele lassen sich nicht laden. Eigene Modelle gehen trotzdem.',
  sample: (name, faces) => `${name}, ${count(faces, 'Fläche', 'Flächen')}`,
  effort: (level, pieces) => `${levels[level]}: ${count(pieces, 'Teil', 'Teile')}`,
  pending: (names) => `Noch nicht angewendet: ${names}.`,
};

function length(mm: number): string {
  if (mm < 10) return `${rounded(mm)} mm`;
  if (mm < 1000) return `${rounded(mm / 10, mm < 100 ? 2 : 3)} cm`;
  return `${rounded(mm / 1000)} m`;
}

export const check: Words['check'] = {
  length,
  triangles: (faces) => `Dieses Modell hat ${large(faces)} Dreiecke.`,
  fine: 'Das passt gut für Papier.',
  proposed: (proposal) =>
    `Papiermodelle haben 200 bis 1500, darum sind ${large(proposal)} eingestellt: Das Bild zeigt, was von der Form bleibt.`,
  making: (wanted) => `Macht ein Modell aus: ${wanted} …`,
  shown: (faces) => `Das Bild hat ${large(faces)} Dreiecke.`,
  asItIs: (faces) => `so, wie es ist: ${large(faces)}`,
  all: (faces) => `alle ${large(faces)} Dreiecke`,
  some: (faces) => `${large(faces)} Dreiecke`,
  tooMany: (faces, most) =>
    `Alle ${large(faces)} sind zu viele: Netze aus mehr als ${large(most)} Dreiecken würden Stunden dauern ` +
    'und wären zu klein zum Falten.',
  bodies: (bodies) =>
    `Das Modell besteht aus ${large(bodies)} einzelnen Körpern, jeder mit eigenen Netzen.`,
  tiny: (bodies) =>
    `${large(bodies)} davon ${choose(bodies, 'ist', 'sind')} winzig: weniger als 3 % so lang wie das Modell. ` +
    `Das Bild zeigt ${choose(bodies, 'ihn', 'sie')} in Farbe.`,
  holes: ({ count: number, small, smallPercent }) => {
    const few = `${large(small)} davon ${choose(small, 'ist', 'sind')} klein: höchstens ${figure(smallPercent)} % so breit, wie das Modell lang ist.`;
    const isMixed = small > 0 && small < number;
    return `Das Modell hat ${count(number, 'Loch', 'Löcher')}. ${isMixed ? `${few} ` : ''}Was ein Loch schließt, bekommt die Farben daneben.`;
  },
  inside: (bodies) =>
    bodies === 1
      ? 'Ein Körper liegt in einem anderen, wo ihn niemand sehen wird. Ohne ihn gibt es weniger zu schneiden und zu kleben.'
      : `${large(bodies)} Körper liegen in anderen, wo sie niemand sehen wird. Ohne sie gibt es weniger zu schneiden und zu kleben.`,
  netsKept:
    'Das Modell wird genau wie in seiner Datei geschnitten und gefaltet, in derselben Größe, wenn das Papier dafür reicht.',
  netsOffered: (pieces) =>
    pieces === 1
      ? 'Die Datei bringt ein eigenes Netz mit. Behalte es, um wie dessen Erfinder zu schneiden und zu falten, oder lass neue Netze machen.'
      : `Die Datei bringt eigene Netze mit, ${large(pieces)} Teile. Behalte sie, um wie deren Erfinder zu schneiden und zu falten, oder lass neue Netze machen.`,
  size: (p) =>
    `${length(p.height)} hoch, ${length(p.width)} breit, ${length(p.depth)} tief, neben einem Bleistift von ${length(p.pencil)}.`,
  fits: {
    new: 'So groß, wie ein Blatt erlaubt: Wie groß das ist, siehst du nach dem Abwickeln.',
    file: 'So groß wie in der Datei oder wie ein Blatt erlaubt: Wie groß das ist, siehst du nach dem Abwickeln.',
    other: 'Wie groß es wird, siehst du nach dem Abwickeln.',
  },
  chooseHeight: 'Wähle eine Höhe, um es neben einem Bleistift zu sehen.',
};

export const form: Words['form'] = {
  height: 'Höhe, mm',
  width: 'Breite, mm',
  depth: 'Tiefe, mm',
  scale: 'Faktor',
  sheets: 'Blätter höchstens',
  holesUpTo: (percent) => `bis ${figure(percent)} % der Länge schließen`,
  solver: {
    tree: 'Bessert eine Abwicklung Schritt für Schritt aus: schnell.',
    genetic: 'Wie im Fachartikel: züchtet Netze; langsam.',
  },
  folding: {
    prefer:
      'Von jedem Netz, das sich falten lässt, ohne sich selbst zu treffen, ist das bewiesen; andere werden gemeldet.',
    require: 'Ein Abschnitt ohne faltbares Netz wird in Teile zerlegt, die sich falten lassen.',
    off: 'Netze müssen nur flach liegen.',
  },
};

const pens =
  'Rote Linien werden geschnitten, blaue und grüne geritzt, rosa Linien mit einem Stift gezeichnet.';

export const printing: Words['printing'] = {
  machine: {
    none: 'Für Schere oder Messer.',
    silhouette: `${pens} An den schwarzen Marken findet die Maschine ein gedrucktes Blatt.`,
    cricut: `${pens} Das Programm von Cricut setzt eigene Marken.`,
    generic: pens,
  },
  noColours: 'Diese Maschine bekommt nur Linien.',
  noPartColours: 'Diese Maschine würde um diese Farben herum schneiden, darum fehlen sie.',
  noLooks: 'Dieses Modell hat keine eigenen Farben.',
  longer: (percent) => `${percent} % länger`,
  shorter: (percent) => `${percent} % kürzer`,
  correcting: (across, up) =>
    `Die Korrektur ist an: Linien werden quer ${across} und hoch ${up} gezeichnet. Drucke noch einmal: Die Lineale messen jetzt 50 mm.`,
  notCorrecting: 'Drucke ein Blatt mit 100 % und trage ein, was seine Lineale messen.',
  corrected: (across, up) =>
    `PDF und SVG sind für deinen Drucker korrigiert (${figure(across)} × ${figure(up)} mm)`,
  frame: 'Seiten zum Drucken',
  page: (sheet, sheets, width, height) => {
    const size = `${figure(width, 1)} × ${figure(height, 1)} mm`;
    return sheet === null
      ? `Bauanleitung, ${size}`
      : `Blatt ${figure(sheet)} von ${figure(sheets)}, ${size}`;
  },
  allSheets: (sheets) => (sheets === 1 ? 'das einzige Blatt' : `alle ${figure(sheets)} Blätter`),
  someSheets: (chosen, sheets) => `${figure(chosen)} von ${count(sheets, 'Blatt', 'Blättern')}`,
  unreadableRange: 'Schreibe Zahlen, zum Beispiel 1-3, 5',
  beyondRange: (sheets) => `Es gibt die Blätter 1 bis ${figure(sheets)}`,
};
