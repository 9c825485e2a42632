/** What the page does for itself; the studio in it is an element, which `../element` defines. */
import { find } from './dom.js';
import { keepForOffline, takeNewestBuild, type OfflineState } from './offline.js';
import { PageLanguage } from './page-language.js';

/** `?workers=N` in the address: for people who want to keep cores free, or use more of them. */
const workers = new URLSearchParams(location.search).get('workers');

const studio = find(document, 'foldwright-studio', HTMLElement);
if (workers !== null) studio.setAttribute('workers', workers);

let offline: OfflineState | null = null;
const language = new PageLanguage(studio, () => tellOffline());

function tellOffline(): void {
  if (offline) find(document, '#offline', HTMLElement).textContent = language.words.site[offline];
}

async function keep(): Promise<void> {
  offline = await keepForOffline();
  tellOffline();
}

// Not before: the files that the page needs come first.
studio.addEventListener('foldwright-ready', () => void keep(), { once: true });
void takeNewestBuild();
