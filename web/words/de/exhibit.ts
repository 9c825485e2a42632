/** What is said in German of a file that is shown with the nets that it brings along. */
import type { Words } from '../words.js';
import { all, choose, count, figure } from './numbers.js';

export const exhibit: Words['exhibit'] = {
  lead: (pieces) =>
    `Das ist nur zum Ansehen: Das Modell und ${choose(pieces, 'sein Netz', `seine ${figure(pieces)} Netze`)} sind zu sehen, wie sie in der Datei sind, ` +
    'und lassen sich hier nicht ändern oder drucken. Neu abgewickelt bekommt das Modell neue Netze und Blätter.',
  nets: (name, pieces) => `Netze von ${name} wie in der Datei: ${count(pieces, 'Teil', 'Teile')}`,
  piece: (name) => `Teil ${name}`,
  chosen: (names) =>
    `${choose(names.length, 'Teil', 'Die Teile')} ${all(names)} ${choose(names.length, 'ist', 'sind')} hervorgehoben.`,
};
