/** Japanese phrases for options that cannot be as they were written. */
import type { ValueFault } from '../../model/option-values.js';
import { paperSizes } from '../../model/paper.js';
import type { OptionFault } from '../messages.js';
import type { StepFault } from '../step-fault.js';
import { figure } from './numbers.js';
import { stepFault } from './repair.js';

/** What is possible instead. */
function expectation(fault: Exclude<ValueFault, StepFault>): string {
  switch (fault.expected) {
    case 'whole':
      return `${figure(fault.least)}から${figure(fault.most)}までの整数`;
    case 'decimal':
      return `${figure(fault.least)}から${figure(fault.most)}までの数`;
    case 'words':
      return fault.words.join('か');
    case 'colour':
      return '#RRGGBBの形の色';
    case 'pair':
      return 'コンマで区切った2つの値';
    case 'dashes':
      return `solid、または線とすき間の長さを交互に並べたもの（${figure(fault.least)}から${figure(fault.most)}まで）`;
    case 'paper': {
      const names = paperSizes.map(({ name }) => name).join('、');
      return `${names}、またはWxH（それぞれ${figure(fault.least)}から${figure(fault.most)} mmまで）`;
    }
  }
}

/** What is wrong with a value, to be read after it. */
function valueFault(fault: ValueFault): string {
  if (fault.expected === 'switches' || fault.expected === 'other-step') return stepFault(fault);
  const about = fault.part === undefined ? '' : `'${fault.part}'はブロックを表していません。`;
  const or = fault.or === undefined ? '' : `、または${fault.or}`;
  return `は使えません。${about}${expectation(fault)}${or}にしてください`;
}

/** What is found out before the engine is asked. */
export function optionFault(fault: OptionFault): string {
  switch (fault.what) {
    case 'no-option':
      return `オプション'${fault.option}'はありません`;
    case 'value':
      return `オプション'${fault.option}'：'${fault.value}'${valueFault(fault)}`;
    case 'fixed':
      return `オプション'${fault.option}'は、ここでは変えられません`;
    case 'second-size':
      return `オプション'${fault.option}'：大きさはもう'${fault.first}'で決まっています`;
    case 'no-paper-left':
      return `オプション'${fault.option}'：${figure(fault.margin_mm)} mmでは、${fault.paper}の用紙に何も残りません`;
    case 'pixels': {
      const sheet = `${figure(fault.width_mm, 1)} x ${figure(fault.height_mm, 1)} mm`;
      return `${sheet}のシートでは、1インチあたり${figure(fault.dpi)}ドットは多すぎます。${figure(fault.possible)}ドットまでにしてください`;
    }
  }
}
