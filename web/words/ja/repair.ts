/** Japanese words about the steps by which a file becomes a surface that can be unfolded. */
import type { NeededStep } from '../../model/repair-steps.js';
import type { Messages, Table } from '../messages.js';
import type { StepFault } from '../step-fault.js';
import type { Words } from '../words.js';
import { figure } from './numbers.js';

const reasons: Record<NeededStep, string> = {
  polygons: '展開図は三角形でできています',
  degenerate: '面積のない面は展開図に置けません',
  'non-manifold': '折り目がつなぐのは2つの面だけです',
};

/** A whole sentence about a step that is named in an option, to be read after it. */
export function stepFault(fault: StepFault): string {
  if (fault.expected === 'switches') {
    return `は使えません。weld=offのように書いてください。使えるのは${fault.steps.join('、')}です`;
  }
  return 'request' in fault
    ? `は使えません。${fault.step}は--${fault.request}で指定したときだけ行います`
    : `は使えません。${fault.step}は止められません。${reasons[fault.step]}`;
}

function stepOff({ what, count }: Messages['step-off']): string {
  const number = figure(count);
  switch (what) {
    case 'weld':
      return `点をまとめる処理を止めています。${number}個の頂点が、ほかの頂点と同じ場所に離れたまま残ります`;
    case 'duplicates':
      return `重複を取り除く処理を止めています。${number}個の面は別の面と同じですが、これも印刷します`;
    case 'two-sided':
      return `表と裏をまとめる処理を止めています。${number}個の面は別の面の裏側にありますが、これも印刷します`;
    case 't-junctions':
      return `角のすき間をふさぐ処理を止めています。${number}本の辺は、途中に隣の面の角があり、開いたままです`;
    case 'cracks':
      return `すき間をふさぐ処理を止めています。すき間のわきにある${number}本の辺は開いたままです`;
    case 'winding':
      return `面を裏返す処理を止めています。${number}個の面は印刷する側が内側になり、外側に向いた隣の面から離れます`;
    case 'flatten':
      return `平らにする処理を止めています。平らに描かれた${number}個の面が、少し曲がったまま残ります`;
  }
}

export const repairMessages = {
  'flat-bodies': ({ count }) =>
    `${figure(count)}個の閉じた立体は、面が重なり合っていて厚みがありません。` +
    'それぞれの面を印刷します。裏どうしを貼り合わせると1枚になります',
  'step-off': stepOff,
} satisfies Partial<Table>;

export const repairSteps: Words['repairSteps'] = {
  weld: '同じ場所の点をまとめる',
  duplicates: '同じ面を取り除く',
  'two-sided': '表と裏を1枚にする',
  't-junctions': '角のすき間をふさぐ',
  cracks: 'すき間をふさぐ',
  winding: '面の表裏をそろえる',
  flatten: '平らに描かれた面を平らにする',
};
