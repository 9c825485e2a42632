/** What stands in German on the sheets that are cut. */
import type { Words } from '../words.js';
import { figure } from './numbers.js';

export const sheets: Words['sheets'] = {
  note: (sheet, of) => `Blatt ${figure(sheet)} von ${figure(of)} · mit 100 % drucken`,
  corrected: (across, up) => `korrigiert für ${figure(across)} × ${figure(up)} mm`,
  outside: ['diese Seite', 'ist außen'],
  back: (sheet, of) =>
    `Rückseite von Blatt ${figure(sheet)} von ${figure(of)} · diese Seite ist innen: Falten wie von hier gesehen`,
  backHow:
    'beidseitig drucken, an der langen Kante gewendet · gegen das Licht decken sich die Kreuze',
  legend: {
    cut: 'Schnittlinie',
    mountain: 'Bergfalte',
    valley: 'Talfalte',
    ticks: 'von Strich zu Strich falten',
    flap: 'Klebelasche',
    number: '12: gehört an die andere 12',
    underlined: 'Zahl mit Strich: Der Strich ist unten',
    pair: 'C3 auf Teil A: gehört an A3 auf Teil C',
    tape: 'zwei Striche über einer Kante: Klebeband',
    strip: 'Streifen A-C:3: hinter Kante C3 von A',
    angle: '34°: Faltwinkel',
  },
};
