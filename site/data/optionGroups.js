// The options with their pictures, as `site/pictures/make.mjs` has left them, in groups.
import { readFileSync } from 'node:fs';

const groups = {
  nets: {
    title: 'The model and its nets',
    about:
      'These decide how the model is read, cut into parts and unfolded: they take a new search.',
  },
  paper: {
    title: 'Size, sheets, flaps and numbers',
    about: 'These lay the same nets out in another way. A change takes a moment.',
  },
  lines: {
    title: 'What is printed, and how',
    about: 'These change how sheets look. Pieces stay where they are.',
  },
};

export default () => {
  const options = JSON.parse(readFileSync('build/site/options.json', 'utf8'));
  return Object.entries(groups).map(([name, { title, about }]) => ({
    title,
    about,
    options: options.filter(({ group }) => group === name),
  }));
};
