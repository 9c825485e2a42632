/** Formats in which results are drawn. */
export const drawnFormats = ['fold', 'svg', 'pdf', 'dxf', 'png', 'glb'] as const;
export type DrawnFormat = (typeof drawnFormats)[number];

/** Formats in which results are written; `foldwright` holds the document itself. */
export const exportFormats = [...drawnFormats, 'foldwright'] as const;
export type ExportFormat = (typeof exportFormats)[number];

/** A file, not yet anywhere. */
export interface WrittenFile {
  name: string;
  bytes: Uint8Array;
}
