/** Reads the models of Pepakura Designer, with their looks and their nets. */
import type { FileNets } from '../../model/file-nets.js';
import type { LookedFiles } from '../../model/looks.js';
import type { Message } from '../../model/message.js';
import type { ModelFile } from '../../model/model-files.js';
import type { PdoFault } from '../../words/messages.js';
import { polygonFile } from '../polygon-file.js';
import { notice } from '../read-model.js';
import { unreadable } from '../unreadable.js';
import { BrokenPdo, PdoBytes } from './pdo-bytes.js';
import { readHeader, UnknownPdo, type PdoHeader } from './pdo-header.js';
import { PdoLooks } from './pdo-looks.js';
import { readMaterials, type PdoMaterial } from './pdo-materials.js';
import { PdoModel } from './pdo-model.js';
import { readObjects, type PdoObject } from './pdo-objects.js';
import { readPattern, type PdoPattern } from './pdo-pattern.js';

/** What comes of a PDO file. */
export interface ReadPdo {
  file: ModelFile;
  looks: LookedFiles;
  nets: FileNets | null;
  notices: Message[];
}

function pdoFault(file: string, fault: PdoFault): Error {
  return unreadable('bad-pdo', { file, ...fault });
}

/** What a file holds besides its shape, as far as it is whole: all that stands behind a fault is lost. */
interface Extras {
  materials: PdoMaterial[];
  pattern: PdoPattern | null;
  isDamaged: boolean;
}

function readExtras(bytes: PdoBytes, header: PdoHeader): Extras {
  const extras: Extras = { materials: [], pattern: null, isDamaged: false };
  try {
    extras.materials = readMaterials(bytes, header.text);
    extras.pattern = readPattern(bytes, header);
  } catch (error) {
    if (!(error instanceof BrokenPdo)) throw error;
    extras.isDamaged = true;
  }
  return extras;
}

/** @throws Unreadable where not even the shape is whole */
function readShape(file: ModelFile, bytes: PdoBytes): { header: PdoHeader; objects: PdoObject[] } {
  try {
    const header = readHeader(bytes);
    if (header.isLocked) throw pdoFault(file.name, { what: 'locked' });
    return { header, objects: readObjects(bytes) };
  } catch (error) {
    if (error instanceof BrokenPdo) throw pdoFault(file.name, { what: 'damaged', at: error.at });
    if (!(error instanceof UnknownPdo)) throw error;
    throw pdoFault(file.name, { what: 'version', version: error.version });
  }
}

function noticesOf({ hidden, broken }: PdoModel, { pattern, isDamaged }: Extras): Message[] {
  const { texts = 0, images = 0 } = pattern ?? {};
  const notices: Message[] = [];
  if (hidden + texts + images > 0) notices.push(notice('pdo-unused', { hidden, texts, images }));
  if (broken > 0) notices.push(notice('broken-faces', { count: broken }));
  if (isDamaged) notices.push(notice('damaged-extras', {}));
  return notices;
}

/** Whether a file is of the first version of the format, which is text. */
function isOldPdo({ bytes }: ModelFile): boolean {
  return bytes[0] === '#'.charCodeAt(0);
}

/** @throws Unreadable for a file that is locked, damaged, of another version, or without a face to be seen */
export function readPdo(file: ModelFile): ReadPdo {
  if (isOldPdo(file)) throw pdoFault(file.name, { what: 'old' });
  const bytes = new PdoBytes(file.bytes);
  const { header, objects } = readShape(file, bytes);
  const extras = readExtras(bytes, header);
  const model = new PdoModel();
  for (const object of objects) model.add(object);
  const looks = new PdoLooks(extras.materials);
  const polygons = model.polygons(looks.files);
  if (polygons.materials.length === 0) {
    throw pdoFault(file.name, { what: model.hidden > 0 ? 'hidden' : 'no-faces' });
  }
  return {
    file: polygonFile(polygons),
    looks: looks.files,
    nets: extras.pattern && model.nets(extras.pattern),
    notices: [...noticesOf(model, extras), ...looks.notices],
  };
}
