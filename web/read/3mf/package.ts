/** A 3MF file as a package of parts that refer to each other by path (Open Packaging Conventions). */
import type { ModelFile } from '../../model/model-files.js';
import type { ThreeMfFault } from '../../words/messages.js';
import { Archive } from '../archive.js';
import { decoded, normalized } from '../paths.js';
import { unreadable } from '../unreadable.js';
import { readModelPart, type ModelPart } from './model-part.js';
import { readSlicerSettings, type SlicerSettings } from './slicer-settings.js';
import { BadXml, parseXml } from './xml.js';

const settingsFiles = ['Metadata/model_settings.config', 'Metadata/Slic3r_PE_model.config'];

/** A package with its parts, which are read when they are asked for. */
export class Package {
  private readonly archive: Archive;
  private readonly byPath: Map<string, string>;
  private readonly parts = new Map<string, ModelPart>();

  constructor(readonly file: ModelFile) {
    this.archive = new Archive(file);
    this.byPath = new Map(this.archive.paths.map((path) => [decoded(path).toLowerCase(), path]));
  }

  get isSliced(): boolean {
    return this.archive.paths.some((path) => /\.gcode$/i.test(path));
  }

  fail(fault: ThreeMfFault): never {
    throw unreadable('bad-3mf', { file: this.file.name, ...fault });
  }

  /** Path of the part that the package begins with, as its relationships say. */
  findStart(): string {
    const bytes = this.bytesOf('_rels/.rels');
    let target: string | undefined;
    const find = (): void =>
      parseXml(bytes!, () => ({
        open: ({ name, get }) => {
          if (name === 'Relationship' && /\/3dmodel$/i.test(get('Type') ?? ''))
            target ??= get('Target');
        },
      }));
    if (bytes) this.xml('_rels/.rels', find);
    // Writers that leave the relationships out keep to the usual place.
    target ??= this.archive.paths.find((path) => /^3D\/[^/]*\.model$/i.test(path));
    return target ?? this.fail({ what: 'no-model' });
  }

  part(path: string): ModelPart {
    const known = this.parts.get(path);
    if (known) return known;
    const bytes = this.bytesOf(path);
    if (!bytes) return this.fail({ what: 'no-part', part: path });
    const part = this.xml(path, () => readModelPart(this.file.name, path, bytes));
    this.parts.set(path, part);
    return part;
  }

  get settings(): SlicerSettings {
    const files = settingsFiles.flatMap((path) => this.bytesOf(path) ?? []);
    return this.xml(settingsFiles[0]!, () => readSlicerSettings(files));
  }

  /** A picture by its path; null if it is not there. */
  picture(path: string): ModelFile | null {
    const bytes = this.bytesOf(path);
    return bytes && { name: decoded(path).replace(/^\/+/, ''), bytes };
  }

  private bytesOf(path: string): Uint8Array | null {
    const name = normalized(path.replace(/^\/+/, ''));
    const found = this.byPath.get(decoded(name ?? '').toLowerCase());
    return found === undefined ? null : this.archive.read(found).bytes;
  }

  private xml<Value>(part: string, work: () => Value): Value {
    try {
      return work();
    } catch (error) {
      if (!(error instanceof BadXml)) throw error;
      return this.fail({ what: 'xml', part, line: error.line });
    }
  }
}
