/** French phrases for options that cannot be as they were written. */
import type { ValueFault } from '../../model/option-values.js';
import { paperSizes } from '../../model/paper.js';
import type { OptionFault } from '../messages.js';
import { figure } from './numbers.js';
import { stepFault } from './repair.js';

function expectation(fault: ValueFault): string {
  switch (fault.expected) {
    case 'whole':
      return `n’est pas un nombre entier de ${figure(fault.least)} à ${figure(fault.most)}`;
    case 'decimal':
      return `n’est pas un nombre de ${figure(fault.least)} à ${figure(fault.most)}`;
    case 'words':
      return `n’est pas ${fault.words.join(' ou ')}`;
    case 'colour':
      return 'n’est pas #RRGGBB';
    case 'pair':
      return 'n’est pas une paire de valeurs séparées par une virgule';
    case 'dashes':
      return (
        'n’est ni solid ni une suite de longueurs de tirets et d’espaces, de ' +
        `${figure(fault.least)} à ${figure(fault.most)}`
      );
    case 'switches':
    case 'other-step':
      return stepFault(fault);
    case 'paper': {
      const names = paperSizes.map(({ name }) => name).join(', ');
      return `n’est ni ${names} ni LxH avec ${figure(fault.least)} à ${figure(fault.most)} mm chacun`;
    }
  }
}

/** What is wrong with a value, to be read after it: "n’est pas #RRGGBB". */
function valueFault(fault: ValueFault): string {
  const about = fault.part === undefined ? '' : `ne nomme aucune partie\u202f: '${fault.part}' `;
  const or = fault.or === undefined ? '' : `, ni ${fault.or}`;
  return about + expectation(fault) + or;
}

export function optionFault(fault: OptionFault): string {
  switch (fault.what) {
    case 'no-option':
      return `il n’y a pas d’option '${fault.option}'`;
    case 'value':
      return `option '${fault.option}'\u202f: '${fault.value}' ${valueFault(fault)}`;
    case 'fixed':
      return `option '${fault.option}'\u202f: on ne peut pas la changer ici`;
    case 'second-size':
      return `option '${fault.option}'\u202f: la taille est déjà donnée par '${fault.first}'`;
    case 'no-paper-left':
      return `option '${fault.option}'\u202f: ${figure(fault.margin_mm)} mm ne laissent rien du papier ${fault.paper}`;
    case 'pixels': {
      const sheet = `${figure(fault.width_mm, 1)} x ${figure(fault.height_mm, 1)} mm`;
      return `${figure(fault.dpi)} points par pouce, c’est trop pour des feuilles de ${sheet}\u202f: ${figure(fault.possible)} sont possibles`;
    }
  }
}
