/** German phrases for lists of edits that cannot be read. */
import type { EditFault, FieldFault } from '../../model/document-edits.js';
import { figure } from './numbers.js';

function expectation(fault: FieldFault): string {
  switch (fault.expected) {
    case 'number':
      return 'ist keine Zahl';
    case 'text':
      return 'ist kein Text';
    case 'flag':
      return 'ist weder true noch false';
    case 'options':
      return 'hat keine Optionen';
    case 'edge':
      return 'ist nicht zwei Ecken';
    case 'whole':
      return `ist keine ganze Zahl ab ${figure(fault.least)}`;
    case 'list':
      return `ist keine Liste von ${figure(fault.least)} oder mehr Zahlen`;
    case 'one-of':
      return `ist keines von ${fault.words.join(', ')}`;
  }
}

/** What is wrong with a list of edits, and in which of them. */
export function editsFault(fault: EditFault): string {
  if (fault.what === 'no-list') return 'die Änderungen sind keine Liste';
  const edit = `Änderung ${figure(fault.edit)}`;
  switch (fault.what) {
    case 'no-object':
      return `${edit} ist kein Objekt`;
    case 'no-kind':
      return `${edit} hat die Art '${fault.kind}', die keine von ${fault.kinds.join(', ')} ist`;
    case 'no-field':
      return `${edit} (${fault.kind}): es gibt kein '${fault.field}'`;
    case 'field':
      return `${edit} (${fault.kind}): '${fault.field}' ${expectation(fault)}`;
  }
}
