/** What stands in French on the sheets that are cut; of its spaces the same holds as in `building.ts`. */
import type { Words } from '../words.js';
import { figure } from './numbers.js';

export const sheets: Words['sheets'] = {
  note: (sheet, of) => `feuille ${figure(sheet)} sur ${figure(of)} · imprimer à 100\u00a0%`,
  corrected: (across, up) => `corrigée pour ${figure(across)} × ${figure(up)} mm`,
  outside: ['ce côté est', 'à l’extérieur'],
  back: (sheet, of) =>
    `dos de la feuille ${figure(sheet)} sur ${figure(of)} · ce côté est à l’intérieur\u00a0: plis vus d’ici`,
  backHow:
    'imprimer en recto verso, en tournant sur le bord long · à contre-jour, les croix se superposent',
  legend: {
    cut: 'trait de coupe',
    mountain: 'pli montagne',
    valley: 'pli vallée',
    ticks: 'plier d’un repère à l’autre',
    flap: 'languette à coller',
    number: '12\u00a0: va avec l’autre 12',
    underlined: 'numéro souligné\u00a0: le trait est en bas',
    pair: 'C3 sur la pièce A\u00a0: va avec A3 sur la pièce C',
    tape: 'deux traits en travers d’une arête\u00a0: ruban adhésif',
    strip: 'bande A-C:3\u00a0: derrière l’arête C3 de A',
    angle: '34°\u00a0: angle du pli',
  },
};
