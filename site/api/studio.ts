/**
 * The script `foldwright/studio`, which defines `<foldwright-studio>`.
 *
 * @module foldwright/studio
 */
export * from '../../web/element/foldwright-studio.js';
