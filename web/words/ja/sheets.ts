/** What stands in Japanese on the sheets that are cut, and beside lines in files. */
import type { Words } from '../words.js';
import { figure } from './numbers.js';

export const sheets: Words['sheets'] = {
  note: (sheet, sheets) => `シート${figure(sheet)}／${figure(sheets)} · 100%で印刷`,
  corrected: (across, up) => `${figure(across)} × ${figure(up)} mmに合わせて補正`,
  outside: ['この面が', '外側'],
  back: (sheet, sheets) =>
    `シート${figure(sheet)}／${figure(sheets)}の裏 · この面が内側：折り目はこちらから見た向き`,
  backHow: '長辺とじで両面印刷 · 光に透かすと十字が重なる',
  legend: {
    cut: '切り取り線',
    mountain: '山折り',
    valley: '谷折り',
    ticks: '印から印まで折る',
    flap: 'のりしろ',
    number: '12：もう1つの12と貼り合わせる',
    underlined: '線付きの番号：線のある方が下',
    pair: '部品AのC3：部品CのA3と貼り合わせる',
    tape: '辺を横切る2本線：テープで貼る',
    strip: 'つなぎ紙A-C:3：Aの辺C3の裏に貼る',
    angle: '34°：折る角度',
  },
};
