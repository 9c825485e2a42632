/** What the command line says in German. */
import type { UsageFault } from '../command-faults.js';
import type { Words } from '../words.js';
import { count, figure } from './numbers.js';
import { excess } from './readers.js';

function usageFault(fault: UsageFault): string {
  switch (fault.what) {
    case 'unknown-option': {
      const { option, similar } = fault;
      const hint = similar.length === 0 ? '' : ` (Meinst du ${similar.join(' oder ')}?)`;
      return `unbekannte Option '${option}'${hint}`;
    }
    case 'no-argument':
      return `das Argument '${fault.argument}' fehlt`;
    case 'no-value':
      return `der Wert der Option '${fault.option}' fehlt`;
    case 'too-many':
      return `zu viele Argumente: ${figure(fault.wanted)} erwartet, ${figure(fault.given)} bekommen`;
    case 'other':
      return fault.text;
  }
}

export const command: Words['command'] = {
  usageFault,
  about: 'Wickelt ein 3D-Modell zu Netzen aus Papier ab.',
  usage: '[Optionen] <model>',
  titles: { usage: 'Aufruf:', arguments: 'Argumente:', options: 'Optionen:' },
  withDefault: (text, value) => `${text} (üblich: ${value})`,
  model:
    'Datei in OBJ, STL, OFF, PLY, GLB, glTF, 3MF, PDO oder FOLD, oder ein Ordner oder ZIP-Archiv mit einer und was dazugehört; ' +
    'oder ein Projekt (.foldwright), dessen Optionen gelten, wenn keine anderen gegeben sind',
  output: (endings) =>
    `eine Datei schreiben, wie ihre Endung sagt: ${endings}; darf mehrmals gegeben sein`,
  report: 'einen Bericht als JSON schreiben',
  split:
    'diesen Abschnitt des Ergebnisses, von 1 gezählt, in k (2) Abschnitte teilen; darf mehrmals gegeben sein',
  merge: 'diese Abschnitte, die sich berühren, vereinen; darf mehrmals gegeben sein',
  edits: 'danach diese Änderungen machen, eine JSON-Liste',
  name: 'zuletzt diesen Abschnitt, von 1 gezählt, benennen; darf mehrmals gegeben sein',
  manyModels: (help) => `Viele Modelle auf einmal: ${help}`,
  quiet: 'auf stderr nichts als Fehler',
  version: 'die Version ausgeben',
  help: 'diese Hilfe zeigen',

  note: (text) => `Hinweis: ${text}`,
  internal: (text) => `interner Fehler: ${text}`,
  namedAlready: (part) => `Option '--name': Abschnitt ${figure(part)} hat schon einen Namen`,
  namedTwice: (path) => `'${path}' ist zweimal genannt`,
  aboutName: (name, fault) => `der Name '${name}': ${fault}`,
  aboutEdit: (edit, fault) => `Änderung ${figure(edit)}: ${fault}`,
  aboutProjectEdit: (edit, fault) => `Änderung ${figure(edit)} des Projekts: ${fault}`,
  aboutFile: (path, fault) => `'${path}': ${fault}`,
  ending: (path, ending, known) => `'${path}': die Endung '${ending}' ist keine von ${known}`,
  noJson: (path) => `'${path}' ist kein JSON`,
  unreadable: (path) => `'${path}' lässt sich nicht lesen`,
  isFolder: (path) => `'${path}' ist ein Ordner`,
  noFolder: (path, folder) => `'${path}': den Ordner '${folder}' gibt es nicht`,
  notAFolder: (path, folder) => `'${path}': '${folder}' ist kein Ordner`,
  notWritable: (path, folder, reason) =>
    `'${path}': in den Ordner '${folder}' lässt sich nicht schreiben (${reason})`,

  noFile: 'diese Datei gibt es nicht',
  notAllowed: 'darf nicht gelesen werden',
  notRead: (reason) => `lässt sich nicht lesen: ${reason}`,
  folderTooLarge: (fault) => `der Ordner hat ${excess(fault)}`,
  emptyFolder: 'in dem Ordner ist keine Datei',
  companionsTooLarge: (fault) => `was dazugehört, hat ${excess(fault)}`,
  notAFile: 'ist keine Datei',
  emptyFile: 'die Datei ist leer',

  idle: (option, without) => `Option '--${option}' ändert nichts ohne ${without}`,
  needs: {
    scale: "'--scale'",
    flaps: 'Laschen',
    folding: 'Falten',
    scissors: "'--machine none'",
    printer: "'--machine none' oder '--machine silhouette'",
    output: (formats) =>
      formats.length > 1
        ? `eine Datei in ${formats.slice(0, -1).join(', ')} oder ${formats.at(-1)}`
        : `eine Datei in ${formats[0]}`,
  },
  summary: (p) =>
    `${p.name}: ${count(p.faces, 'Fläche', 'Flächen')}, ${count(p.parts, 'Abschnitt', 'Abschnitte')}, ` +
    `${count(p.pieces, 'Teil', 'Teile')} auf ${count(p.sheets, 'Blatt', 'Blättern')}, ${p.size}`,
};
