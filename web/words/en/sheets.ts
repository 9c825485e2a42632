/** What stands in English on the sheets that are cut, and beside lines in files. */
import { figure } from './numbers.js';

export const sheets = {
  note: (sheet: number, sheets: number): string =>
    `sheet ${figure(sheet)} of ${figure(sheets)} · print at 100 %`,
  corrected: (across: number, up: number): string =>
    `corrected for ${figure(across)} × ${figure(up)} mm`,
  /** In two lines beside an arrow: as few words as possible. */
  outside: ['this side', 'is outside'] as [string, string],
  back: (sheet: number, sheets: number): string =>
    `back of sheet ${figure(sheet)} of ${figure(sheets)} · this side is inside: folds as seen from here`,
  backHow: 'print on both sides, turned along the long edge · against the light the crosses meet',
  legend: {
    cut: 'cut',
    mountain: 'mountain fold',
    valley: 'valley fold',
    ticks: 'fold from mark to mark',
    flap: 'flap for glue',
    number: '12: joins the other 12',
    underlined: 'number with a line: the line is below',
    pair: 'C3 on piece A: joins A3 on piece C',
    tape: 'two strokes across an edge: tape',
    strip: 'strip A-C:3: behind edge C3 of A',
    angle: '34°: fold angle',
  },
};
