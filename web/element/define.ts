/** Makes `<foldwright-studio>` known to the page; a second copy of the script finds that done. */
import { FoldwrightStudio, type StudioEventMap } from './studio-element.js';

declare global {
  interface HTMLElementTagNameMap {
    'foldwright-studio': FoldwrightStudio;
  }
  /** For listeners of the element and of what is around it. */
  interface HTMLElementEventMap {
    'foldwright-event': StudioEventMap['foldwright-event'];
    'foldwright-ready': StudioEventMap['foldwright-ready'];
  }
}

if (!customElements.get('foldwright-studio')) {
  customElements.define('foldwright-studio', FoldwrightStudio);
}
