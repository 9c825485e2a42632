/** English phrases for options that cannot be as they were written. */
import type { ValueFault } from '../../model/option-values.js';
import { paperSizes } from '../../model/paper.js';
import type { OptionFault } from '../messages.js';
import { figure } from './numbers.js';
import { stepFault } from './repair.js';

function expectation(fault: ValueFault): string {
  switch (fault.expected) {
    case 'whole':
      return `is not a whole number from ${figure(fault.least)} to ${figure(fault.most)}`;
    case 'decimal':
      return `is not a number from ${figure(fault.least)} to ${figure(fault.most)}`;
    case 'words':
      return `is not ${fault.words.join(' or ')}`;
    case 'colour':
      return 'is not #RRGGBB';
    case 'pair':
      return 'is not two values with a comma between them';
    case 'dashes':
      return (
        'is neither solid nor lengths of dashes and gaps in turn, from ' +
        `${figure(fault.least)} to ${figure(fault.most)}`
      );
    case 'switches':
    case 'other-step':
      return stepFault(fault);
    case 'paper': {
      const names = paperSizes.map(({ name }) => name).join(', ');
      return `is neither ${names} nor WxH with ${figure(fault.least)} to ${figure(fault.most)} mm each`;
    }
  }
}

/** What is wrong with a value, to be read after it: "is not #RRGGBB". */
function valueFault(fault: ValueFault): string {
  const about = fault.part === undefined ? '' : `names no part: '${fault.part}' `;
  const or = fault.or === undefined ? '' : `, nor ${fault.or}`;
  return about + expectation(fault) + or;
}

/** What is found out before the engine is asked. */
export function optionFault(fault: OptionFault): string {
  switch (fault.what) {
    case 'no-option':
      return `there is no option '${fault.option}'`;
    case 'value':
      return `option '${fault.option}': '${fault.value}' ${valueFault(fault)}`;
    case 'fixed':
      return `option '${fault.option}' cannot be changed here`;
    case 'second-size':
      return `option '${fault.option}': the size is given by '${fault.first}' already`;
    case 'no-paper-left':
      return `option '${fault.option}': ${figure(fault.margin_mm)} mm leave nothing of ${fault.paper} paper`;
    case 'pixels': {
      const sheet = `${figure(fault.width_mm, 1)} x ${figure(fault.height_mm, 1)} mm`;
      const dots = `${figure(fault.dpi)} dots per inch`;
      return `${dots} are too many for sheets of ${sheet}: ${figure(fault.possible)} are possible`;
    }
  }
}
