/** What the page does for itself; the studio in it is an element, which `../element` defines. */
import { find } from './dom.js';
import { keepForOffline, takeNewestBuild } from './offline.js';

/** `?workers=N` in the address: for people who want to keep cores free, or use more of them. */
const workers = new URLSearchParams(location.search).get('workers');

const studio = find(document, 'foldwright-studio', HTMLElement);
if (workers !== null) studio.setAttribute('workers', workers);
// Not before: the files that the page needs come first.
studio.addEventListener('foldwright-ready', () => void keepForOffline(), { once: true });
void takeNewestBuild();
