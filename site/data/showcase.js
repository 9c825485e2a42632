// The samples of the studio with what it takes to build each, in the words of the studio; those of the least work first.
import { readFileSync } from 'node:fs';
import { fromSources } from '../pictures/from-sources.mjs';

const entry = `
  export { difficultyOf } from './web/model/building-time.js';
  export { english } from './web/words/en/index.js';
`;

export default async function showcase() {
  const { difficultyOf, english } = await fromSources(entry);
  const { building: words, choice } = english;
  const samples = JSON.parse(readFileSync('dist/studio/samples/catalog.json', 'utf8'));
  return samples
    .sort((a, b) => a.building.seconds - b.building.seconds)
    .map(({ name, file, picture, faces, building: { pieces, seconds } }) => ({
      name,
      picture: `/studio/samples/${picture}`,
      address: `/studio/index.html?model=samples/${file}`,
      faces,
      effort: choice.effort(difficultyOf(seconds), pieces),
      time: words.duration({ seconds }),
    }));
}
