import type { DocumentEdit } from '../model/document-edits.js';

type Kind = DocumentEdit['kind'];

/** Of the kinds that are not about parts of the result. */
const words: Readonly<Record<Exclude<Kind, 'split' | 'merge' | 'again' | 'name'>, string>> = {
  assign: 'moving faces',
  cut: 'cutting a fold',
  join: 'joining an edge',
  lock: 'lock of an edge',
  flap: 'flap of an edge',
  place: 'moving a piece',
  unpin: 'letting a piece go',
  paper: 'change of paper',
  print: 'change of look',
};

/** "part 3", "parts 1 and 2"; parts count from 1. */
function partNumbers(parts: readonly number[]): string {
  if (parts.length === 1) return `part ${parts[0]}`;
  return `parts ${parts.slice(0, -1).join(', ')} and ${parts.at(-1)}`;
}

/** The parts that an edit is about by their numbers, from 1. */
export function partsOf(edit: DocumentEdit): readonly number[] {
  if (edit.kind === 'merge') return edit.parts;
  return 'part' in edit ? [edit.part] : [];
}

/** Names edits that are made in one go, to be read after "Undo: ". */
export function editWords(edits: readonly DocumentEdit[]): string {
  const [first] = edits;
  if (!first) return '';
  const parts = partNumbers([...new Set(edits.flatMap(partsOf))]);
  switch (first.kind) {
    case 'split':
      return `split of ${parts}`;
    case 'merge':
      return `merging of ${parts}`;
    case 'again':
      return `another net for ${parts}`;
    case 'name':
      return `name of ${parts}`;
    default:
      return words[first.kind];
  }
}
