/** Formats in which results are written. */
export const exportFormats = ['fold', 'svg', 'pdf', 'dxf', 'png', 'glb'] as const;
export type ExportFormat = (typeof exportFormats)[number];

/** A file, not yet anywhere. */
export interface WrittenFile {
  name: string;
  bytes: Uint8Array;
}
