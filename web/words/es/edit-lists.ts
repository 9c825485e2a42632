/** Spanish phrases for lists of edits that cannot be read. */
import type { EditFault, FieldFault } from '../../model/document-edits.js';
import { figure } from './numbers.js';

function expectation(fault: FieldFault): string {
  switch (fault.expected) {
    case 'number':
      return 'no es un número';
    case 'text':
      return 'no es un texto';
    case 'flag':
      return 'no es ni true ni false';
    case 'options':
      return 'no tiene opciones';
    case 'edge':
      return 'no son dos vértices';
    case 'whole':
      return `no es un número entero desde ${figure(fault.least)}`;
    case 'list':
      return `no es una lista de ${figure(fault.least)} números o más`;
    case 'one-of':
      return `no es ninguno de ${fault.words.join(', ')}`;
  }
}

/** What is wrong with a list of edits, and in which of them. */
export function editsFault(fault: EditFault): string {
  if (fault.what === 'no-list') return 'los cambios no son una lista';
  const edit = `cambio ${figure(fault.edit)}`;
  switch (fault.what) {
    case 'no-object':
      return `${edit}: no es un objeto`;
    case 'no-kind':
      return `${edit}: es del tipo '${fault.kind}', que no es ninguno de ${fault.kinds.join(', ')}`;
    case 'no-field':
      return `${edit} (${fault.kind}): no hay '${fault.field}'`;
    case 'field':
      return `${edit} (${fault.kind}): '${fault.field}' ${expectation(fault)}`;
  }
}
