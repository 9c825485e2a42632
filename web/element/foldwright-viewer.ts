/** Entry for other pages, and for programs that make them: it keeps its name from build to build. */
import { FoldwrightViewer, type ViewerEventMap } from './viewer/viewer-element.js';

declare global {
  interface HTMLElementTagNameMap {
    'foldwright-viewer': FoldwrightViewer;
  }
  /** For listeners of the element and of what is around it. */
  interface HTMLElementEventMap {
    unfold: ViewerEventMap['unfold'];
    'foldwright-event': ViewerEventMap['foldwright-event'];
    'fold-change': ViewerEventMap['fold-change'];
    'selection-change': ViewerEventMap['selection-change'];
    'before-download': ViewerEventMap['before-download'];
  }
}

// Without a DOM there is nothing to define; a second copy of the script finds it done.
if (typeof customElements !== 'undefined' && !customElements.get('foldwright-viewer')) {
  customElements.define('foldwright-viewer', FoldwrightViewer);
}

export { FoldwrightViewer };
export type { UnfoldOptions, ViewerEventMap } from './viewer/viewer-element.js';
export { ViewerError } from './viewer/viewer-fault.js';
export type { ViewerSource } from './viewer/viewer-source.js';
