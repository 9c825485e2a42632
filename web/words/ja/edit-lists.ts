/** Japanese phrases for lists of edits that cannot be read. */
import type { EditFault, FieldFault } from '../../model/document-edits.js';
import { figure } from './numbers.js';

/** To be read after the name of a field. */
function expectation(fault: FieldFault): string {
  switch (fault.expected) {
    case 'number':
      return 'が数ではありません';
    case 'text':
      return 'が文字列ではありません';
    case 'flag':
      return 'がtrueでもfalseでもありません';
    case 'options':
      return 'にオプションがありません';
    case 'edge':
      return 'が2つの頂点ではありません';
    case 'whole':
      return `が${figure(fault.least)}以上の整数ではありません`;
    case 'list':
      return `が${figure(fault.least)}個以上の数のリストではありません`;
    case 'one-of':
      return `が${fault.words.join('、')}のどれでもありません`;
  }
}

/** What is wrong with a list of edits, and in which of them. */
export function editsFault(fault: EditFault): string {
  if (fault.what === 'no-list') return '編集がリストになっていません';
  const edit = `編集${figure(fault.edit)}`;
  switch (fault.what) {
    case 'no-object':
      return `${edit}がオブジェクトではありません`;
    case 'no-kind':
      return `${edit}の種類'${fault.kind}'は、${fault.kinds.join('、')}のどれでもありません`;
    case 'no-field':
      return `${edit}（${fault.kind}）：'${fault.field}'がありません`;
    case 'field':
      return `${edit}（${fault.kind}）：'${fault.field}'${expectation(fault)}`;
  }
}
