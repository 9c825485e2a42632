/** Entry for other pages: it keeps its name from build to build, and what it imports is named by its content. */
import './define.js';

export { FoldwrightStudio, type StudioEventMap } from './studio-element.js';
