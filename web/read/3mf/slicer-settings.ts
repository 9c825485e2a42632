/** What slicers note beside a model: which parts of it are not printed, but change how others are. */
import { parseXml } from './xml.js';

export type Role = 'print' | 'modifier' | 'negative';

/** Triangles of an object's mesh that have a role of their own. */
export interface VolumeRole {
  first: number;
  last: number;
  role: Role;
}

/** Roles of parts, by the numbers of their objects. */
export interface SlicerSettings {
  /** Of the components of objects: object, then component. */
  components: Map<string, Map<string, Role>>;
  /** Of ranges of triangles. */
  volumes: Map<string, VolumeRole[]>;
}

/** Words of PrusaSlicer (`ModelPart`, `NegativeVolume`), and of Bambu Studio and OrcaSlicer (`normal_part`). */
function roleOf(word: string): Role {
  if (/^(?:ModelPart|normal_part)$/.test(word)) return 'print';
  return /^negative/i.test(word) ? 'negative' : 'modifier';
}

/** Reads `Metadata/model_settings.config` and `Metadata/Slic3r_PE_model.config`. @throws BadXml */
export function readSlicerSettings(files: readonly Uint8Array[]): SlicerSettings {
  const settings: SlicerSettings = { components: new Map(), volumes: new Map() };
  for (const bytes of files) {
    let object = '';
    let volume: VolumeRole | null = null;
    parseXml(bytes, () => ({
      open({ name, get }) {
        if (name === 'object') {
          object = get('id') ?? '';
          settings.components.set(
            object,
            settings.components.get(object) ?? new Map<string, Role>(),
          );
          settings.volumes.set(object, settings.volumes.get(object) ?? []);
        } else if (name === 'part') {
          const role = roleOf(get('subtype') ?? 'normal_part');
          settings.components.get(object)?.set(get('id') ?? '', role);
        } else if (name === 'volume') {
          volume = { first: Number(get('firstid')), last: Number(get('lastid')), role: 'print' };
          settings.volumes.get(object)?.push(volume);
        } else if (name === 'metadata' && volume) {
          if (get('key') === 'volume_type') volume.role = roleOf(get('value') ?? '');
          // Before there were several types.
          if (get('key') === 'modifier' && get('value') === '1') volume.role = 'modifier';
        }
      },
      close(_, name) {
        if (name === 'volume') volume = null;
      },
    }));
  }
  return settings;
}
