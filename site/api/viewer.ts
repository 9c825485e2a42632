/**
 * The script `foldwright/viewer`, which defines `<foldwright-viewer>`.
 *
 * @module foldwright/viewer
 */
export * from '../../web/element/foldwright-viewer.js';
