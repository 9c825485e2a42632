/** English phrases for lists of edits that cannot be read. */
import type { EditFault, FieldFault } from '../../model/document-edits.js';
import { figure } from './numbers.js';

function expectation(fault: FieldFault): string {
  switch (fault.expected) {
    case 'number':
      return 'is not a number';
    case 'text':
      return 'is not a text';
    case 'flag':
      return 'is neither true nor false';
    case 'options':
      return 'has no options';
    case 'edge':
      return 'is not two vertices';
    case 'whole':
      return `is not a whole number from ${figure(fault.least)} on`;
    case 'list':
      return `is not a list of ${figure(fault.least)} or more numbers`;
    case 'one-of':
      return `is none of ${fault.words.join(', ')}`;
  }
}

/** What is wrong with a list of edits, and in which of them. */
export function editsFault(fault: EditFault): string {
  if (fault.what === 'no-list') return 'the edits are no list';
  const edit = `edit ${figure(fault.edit)}`;
  switch (fault.what) {
    case 'no-object':
      return `${edit} is no object`;
    case 'no-kind':
      return `${edit} has the kind '${fault.kind}', which is none of ${fault.kinds.join(', ')}`;
    case 'no-field':
      return `${edit} (${fault.kind}): there is no '${fault.field}'`;
    case 'field':
      return `${edit} (${fault.kind}): '${fault.field}' ${expectation(fault)}`;
  }
}
