/** Spanish phrases for options that cannot be as they were written. */
import type { ValueFault } from '../../model/option-values.js';
import { paperSizes } from '../../model/paper.js';
import type { OptionFault } from '../messages.js';
import { figure } from './numbers.js';
import { stepFault } from './repair.js';

function expectation(fault: ValueFault): string {
  switch (fault.expected) {
    case 'whole':
      return `no es un número entero de ${figure(fault.least)} a ${figure(fault.most)}`;
    case 'decimal':
      return `no es un número de ${figure(fault.least)} a ${figure(fault.most)}`;
    case 'words':
      return `no es ${fault.words.join(' ni ')}`;
    case 'colour':
      return 'no es #RRGGBB';
    case 'pair':
      return 'no son dos valores con una coma en medio';
    case 'dashes':
      return (
        'no es ni solid ni una lista de largos de trazos y huecos por turno, de ' +
        `${figure(fault.least)} a ${figure(fault.most)}`
      );
    case 'switches':
    case 'other-step':
      return stepFault(fault);
    case 'paper': {
      const names = paperSizes.map(({ name }) => name).join(', ');
      return `no es ni ${names} ni WxH con ${figure(fault.least)} a ${figure(fault.most)} mm cada uno`;
    }
  }
}

/** What is wrong with a value, to be read after it: "no es #RRGGBB". */
function valueFault(fault: ValueFault): string {
  const about = fault.part === undefined ? '' : `no nombra ninguna parte: '${fault.part}' `;
  const or = fault.or === undefined ? '' : `, ni ${fault.or}`;
  return about + expectation(fault) + or;
}

/** What is found out before the engine is asked. */
export function optionFault(fault: OptionFault): string {
  switch (fault.what) {
    case 'no-option':
      return `no existe la opción '${fault.option}'`;
    case 'value':
      return `opción '${fault.option}': '${fault.value}' ${valueFault(fault)}`;
    case 'fixed':
      return `la opción '${fault.option}' no se puede cambiar aquí`;
    case 'second-size':
      return `opción '${fault.option}': el tamaño ya lo da '${fault.first}'`;
    case 'no-paper-left':
      return `opción '${fault.option}': ${figure(fault.margin_mm)} mm no dejan nada del papel ${fault.paper}`;
    case 'pixels': {
      const sheet = `${figure(fault.width_mm, 1)} x ${figure(fault.height_mm, 1)} mm`;
      const dots = `${figure(fault.dpi)} puntos por pulgada`;
      return `${dots} son demasiados para hojas de ${sheet}: se puede llegar a ${figure(fault.possible)}`;
    }
  }
}
