/** What the page does for itself; the studio in it is an element, which `../element` defines. */
import { find } from './dom.js';
import { keepForOffline, takeNewestBuild, type OfflineState } from './offline.js';
import { PageLanguage } from './page-language.js';
import { requestedAttributes } from './page-request.js';

const studio = find(document, 'foldwright-studio', HTMLElement);
for (const [name, value] of requestedAttributes(location.search)) studio.setAttribute(name, value);

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
