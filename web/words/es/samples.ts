/** Spanish names of the sample models. */
import type { Words } from '../words.js';

export const samples: Words['samples'] = {
  whale: 'Ballena',
  duck: 'Pato',
  cat: 'Gato',
  rabbit: 'Conejo',
  fish: 'Pez',
  heart: 'Corazón',
  knot: 'Nudo',
  star: 'Estrella',
  house: 'Casa',
  torus: 'Anillo',
  icosahedron: 'Icosaedro',
  cube: 'Cubo',
};
