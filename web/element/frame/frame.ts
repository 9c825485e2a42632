/**
 * The page of a frame with a viewer. Its address has the viewer's attributes, and as `parent` the origin of the page
 * around it, if that is to talk with it: `viewer-frame.html?parent=https://shop.example&src=whale.fold&controls`.
 */
import { FoldwrightViewer } from '../foldwright-viewer.js';
import { reflected } from '../viewer/viewer-attributes.js';
import { FrameBridge } from './frame-bridge.js';

const asked = new URLSearchParams(location.search);
const viewer = new FoldwrightViewer();
for (const name of [...reflected, 'fold', 'lang']) {
  const value = asked.get(name);
  if (value !== null) viewer.setAttribute(name, value);
}
document.body.append(viewer);

const origin = asked.get('parent');
// In a page of its own there is nobody to talk with.
if (origin !== null && parent !== window) new FrameBridge(viewer, parent, new URL(origin).origin);
