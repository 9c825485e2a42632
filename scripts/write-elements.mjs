// dist/custom-elements.json: the manifest of the elements, which the package ships.
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { elementsManifest } from './elements-manifest.mjs';
import { root } from './setup/paths.mjs';

const text = JSON.stringify(elementsManifest(), null, 2);
writeFileSync(join(root, 'dist/custom-elements.json'), `${text}\n`);
