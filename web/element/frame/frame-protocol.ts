/** What a page and a frame with the viewer send to each other by `postMessage`: plain values only, no code. */
import type { Options } from '../../api/written-options.js';
import type { Report } from '../../export/report.js';
import type { ExportFormat, WrittenFile } from '../../export/formats.js';
import type { ModelFiles } from '../../model/model-files.js';
import type { ViewerEventMap } from '../viewer/viewer-element.js';

/** Of this protocol. Messages of another one are left alone. */
export const frameVersion = 1;

/** What is asked for, and what the answer to it holds. */
export interface FrameAsks {
  /** An address, from the frame, or files. */
  load: { needs: { source: string | ModelFiles }; gives: null };
  unfold: { needs: object; gives: Report };
  cancel: { needs: object; gives: null };
  /** To a time from 0 (flat) to 1; answers when it is there. */
  fold: { needs: { time: number }; gives: null };
  export: { needs: { format: ExportFormat; options?: Options }; gives: WrittenFile[] };
  project: { needs: object; gives: WrittenFile };
  /** Sets attributes of the viewer; null takes one away. */
  set: { needs: { attributes: Readonly<Record<string, string | null>> }; gives: null };
}

export type FrameAsk = keyof FrameAsks;

/** From the page. `id` comes back with the answer. */
export type FrameRequest = {
  [Ask in FrameAsk]: {
    foldwright: typeof frameVersion;
    id: number;
    ask: Ask;
  } & FrameAsks[Ask]['needs'];
}[FrameAsk];

/** From the frame, once for each request. */
export type FrameAnswer =
  | { foldwright: typeof frameVersion; id: number; ok: true; value: FrameAsks[FrameAsk]['gives'] }
  | { foldwright: typeof frameVersion; id: number; ok: false; code: string; message: string };

/** Events of the viewer that the page hears of. */
export const toldEvents = [
  'load',
  'unfold',
  'fold-change',
  'selection-change',
  'error',
] as const satisfies readonly (keyof ViewerEventMap)[];

/** From the frame, by itself. `ready`: it answers from now on. */
export interface FrameNews {
  foldwright: typeof frameVersion;
  event: 'ready' | (typeof toldEvents)[number];
  detail: unknown;
}

/** Whether a message is a request. What it asks for beyond that is looked at when it is done. */
export function isRequest(data: unknown): data is FrameRequest {
  if (typeof data !== 'object' || data === null) return false;
  const { foldwright, id, ask } = data as Record<string, unknown>;
  return foldwright === frameVersion && typeof id === 'number' && typeof ask === 'string';
}
