/** What the readers hand over. */
import type { FileNets } from '../model/file-nets.js';
import type { JobOptions } from '../model/job-options.js';
import type { LookedFiles } from '../model/looks.js';
import type { Message } from '../model/message.js';
import type { ModelFile } from '../model/model-files.js';
import type { Code, Messages } from '../words/messages.js';

/** A model in a file that the engine reads. */
export interface ReadModel {
  /** The file that it was read from, as people know it. */
  name: string;
  /** For the engine. */
  file: ModelFile;
  /** Materials and pictures, by the numbers that the file has of them; null if there are none that are known yet. */
  looks: LookedFiles | null;
  /** Files beside it that it names, and that only those know how to use who know what the engine reads of it. */
  companions: ModelFile[];
  /** Nets that the file brings along; absent where it has none. */
  nets?: FileNets;
  /** What is to be told of the files. */
  notices: Message[];
  /** What its format says, where nobody says otherwise. */
  usual: Partial<Pick<JobOptions, 'up' | 'unit'>>;
}

/** What readers need of where they run. */
export interface ReaderTools {
  /** Gets the WASM that decodes Draco. */
  loadDraco: () => Promise<Uint8Array>;
}

export function notice<Name extends Code>(
  code: Name,
  params: Messages[Name] & Message['params'],
): Message {
  return { code, params };
}
