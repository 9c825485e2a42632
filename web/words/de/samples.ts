/** German names of the sample models. */
import type { Words } from '../words.js';

export const samples: Words['samples'] = {
  whale: 'Wal',
  duck: 'Ente',
  cat: 'Katze',
  rabbit: 'Kaninchen',
  fish: 'Fisch',
  heart: 'Herz',
  knot: 'Knoten',
  star: 'Stern',
  house: 'Haus',
  torus: 'Ring',
  icosahedron: 'Ikosaeder',
  cube: 'Würfel',
};
