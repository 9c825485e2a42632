/** English names of the sample models, by their ids. */
export const samples = {
  whale: 'Whale',
  duck: 'Duck',
  cat: 'Cat',
  rabbit: 'Rabbit',
  fish: 'Fish',
  heart: 'Heart',
  knot: 'Knot',
  star: 'Star',
  house: 'House',
  torus: 'Ring',
  icosahedron: 'Icosahedron',
  cube: 'Cube',
};
