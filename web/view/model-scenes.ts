/** All that draws models with three.js, for who loads it when it is needed. */
export { ModelScene } from './model-scene.js';
export { OwnScreen } from './model-screen.js';
export { SharedRenderer } from './shared-renderer.js';
