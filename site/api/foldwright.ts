/**
 * The package `foldwright`, in pages as under node: `import { open, unfold } from 'foldwright'`.
 *
 * @module foldwright
 */
export * from '../../web/api/browser.js';
