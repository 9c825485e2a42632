/** The demonstrations of the pages about how it works. */
import { clustering } from './clustering.js';
import { demoElement } from './demo-element.js';
import { learning } from './learning.js';
import { search } from './search.js';

for (const [name, demo] of Object.entries({ learning, clustering, search })) {
  customElements.define(`foldwright-${name}`, demoElement(demo));
}
