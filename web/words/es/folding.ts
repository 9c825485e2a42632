/** What is said in Spanish of folding and of the steps in which a model is built. */
import type { Words } from '../words.js';
import { all, counted, figure } from './numbers.js';

export const folding: Words['folding'] = {
  flat: 'plano',
  foldedBy: (percent) => `plegado al ${figure(percent)} %`,
  folded: 'plegado',
  whole: 'el modelo',
  inPlace: (piece) => `la pieza ${piece} está en su sitio`,
  joining: (piece) => `uniendo la pieza ${piece}`,
  doubts: (names) =>
    `No se conoce ninguna forma de plegar ${names === null ? 'estas piezas' : all(names)}: ` +
    'en la imagen todos los pliegues giran por igual, y unas caras pueden atravesar otras.',
  play: 'Reproducir',
  pause: 'Pausar',
};

const ways = { mountain: 'en montaña', valley: 'en valle' } as const;

export const steps: Words['steps'] = {
  done: (done, of) => `${figure(done)} de ${figure(of)} hechos`,
  pieceDone: (piece) => `La pieza ${piece} está lista`,
  piece: (piece) => `Pieza ${piece}:`,
  crease: ({ folds, crease, turn }) => {
    if (folds === 0) return 'no tiene pliegues.';
    const [own, other] = [ways[crease], ways[crease === 'mountain' ? 'valley' : 'mountain']];
    if (turn === 0) {
      return folds === 1
        ? `haz su único pliegue ${own}.`
        : `haz sus ${figure(folds)} pliegues ${own}.`;
    }
    const turned =
      turn === 1
        ? `cambia este y hazlo ${other}`
        : `cambia estos ${figure(turn)} y hazlos ${other}`;
    return `haz sus ${figure(folds)} pliegues ${own} y después ${turned}.`;
  },
  close: (seams) =>
    seams === 1
      ? 'Cierra su unión.'
      : `Cierra sus ${figure(seams)} uniones en el orden de sus números.`,
  glue: (names, edges) => `Pégala a ${all(names)} por ${counted.edges(edges)}.`,
};
