/** French phrases for lists of edits that cannot be read. */
import type { EditFault, FieldFault } from '../../model/document-edits.js';
import { count, figure } from './numbers.js';

function expectation(fault: FieldFault): string {
  switch (fault.expected) {
    case 'number':
      return 'n’est pas un nombre';
    case 'text':
      return 'n’est pas un texte';
    case 'flag':
      return 'n’est ni true ni false';
    case 'options':
      return 'n’a pas d’options';
    case 'edge':
      return 'n’est pas une paire de sommets';
    case 'whole':
      return `n’est pas un nombre entier à partir de ${figure(fault.least)}`;
    case 'list':
      return `n’est pas une liste d’au moins ${count(fault.least, 'nombre', 'nombres')}`;
    case 'one-of':
      return `ne fait pas partie de ${fault.words.join(', ')}`;
  }
}

/** What is wrong with a list of edits, and in which of them. */
export function editsFault(fault: EditFault): string {
  if (fault.what === 'no-list') return 'les modifications ne sont pas une liste';
  const edit = `modification ${figure(fault.edit)}`;
  switch (fault.what) {
    case 'no-object':
      return `${edit}\u202f: ce n’est pas un objet`;
    case 'no-kind':
      return `${edit}\u202f: le genre '${fault.kind}' ne fait pas partie de ${fault.kinds.join(', ')}`;
    case 'no-field':
      return `${edit} (${fault.kind})\u202f: il n’y a pas de '${fault.field}'`;
    case 'field':
      return `${edit} (${fault.kind})\u202f: '${fault.field}' ${expectation(fault)}`;
  }
}
