/** What is said in English of a file that is shown with the nets that it brings along. */
import { all, choose, count } from './numbers.js';

export const exhibit = {
  lead: (pieces: number): string =>
    `This is only a look: the model and its ${count(pieces, 'net')} are shown as they are in the file, ` +
    'and cannot be changed or printed here. Unfolded anew, the model gets new nets and sheets.',
  nets: (name: string, pieces: number): string =>
    `Nets of ${name} as in the file: ${count(pieces, 'piece')}`,
  piece: (name: string): string => `Piece ${name}`,
  chosen: (names: readonly string[]): string =>
    `${choose(names.length, 'Piece', 'Pieces')} ${all(names)} ${choose(names.length, 'stands', 'stand')} out.`,
};
