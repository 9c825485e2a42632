/** What is said in German of folding and of the steps in which a model is built. */
import type { Words } from '../words.js';
import { all, count, figure } from './numbers.js';

export const folding: Words['folding'] = {
  flat: 'flach',
  foldedBy: (percent) => `zu ${figure(percent)} % gefaltet`,
  folded: 'gefaltet',
  whole: 'das Modell',
  inPlace: (piece) => `Teil ${piece} sitzt`,
  joining: (piece) => `Teil ${piece} kommt dazu`,
  doubts: (names) =>
    `Kein Weg ist bekannt, ${names === null ? 'diese Teile' : all(names)} zu falten: ` +
    'Alle Falten drehen sich im Bild gleichmäßig, und Flächen können durcheinander hindurchgehen.',
  play: 'Abspielen',
  pause: 'Anhalten',
};

const folds = { mountain: 'Bergfalte', valley: 'Talfalte' } as const;

export const steps: Words['steps'] = {
  done: (done, of) => `${figure(done)} von ${figure(of)} fertig`,
  pieceDone: (piece) => `Teil ${piece} ist fertig`,
  piece: (piece) => `Teil ${piece}:`,
  crease: (p) => {
    if (p.folds === 0) return 'Es hat keine Falten.';
    const [own, other] = [folds[p.crease], folds[p.crease === 'mountain' ? 'valley' : 'mountain']];
    if (p.turn === 0) {
      return p.folds === 1
        ? `Falte seine einzige Falte als ${own}.`
        : `Falte seine ${figure(p.folds)} Falten als ${own}n.`;
    }
    const turned =
      p.turn === 1
        ? `wende dann diese eine zur ${other}`
        : `wende dann diese ${figure(p.turn)} zu ${other}n`;
    return `Falte seine ${figure(p.folds)} Falten als ${own}n, ${turned}.`;
  },
  close: (seams) =>
    seams === 1
      ? 'Schließe seine Naht.'
      : `Schließe seine ${figure(seams)} Nähte in der Reihenfolge ihrer Nummern.`,
  glue: (names, edges) =>
    `Klebe es an ${all(names)}, entlang von ${count(edges, 'Kante', 'Kanten')}.`,
};
