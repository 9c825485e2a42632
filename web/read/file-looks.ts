/** What lies beside a model that the engine reads: its materials and pictures. */
import type { EngineLooks, LookedFiles, Material } from '../model/looks.js';
import type { Message } from '../model/message.js';
import type { ModelFile } from '../model/model-files.js';
import { white } from './colours.js';
import type { Companions } from './companions.js';
import { readMtl, type MtlMaterial } from './mtl.js';
import { namesOfLine } from './obj-libraries.js';
import { Pictures } from './pictures.js';
import { plyPictures } from './ply-pictures.js';
import { notice } from './read-model.js';

export interface FileLooks extends LookedFiles {
  /** Whether all faces are of the first material, whatever numbers they have. */
  isForAll: boolean;
  notices: Message[];
}

const plain = {
  colour: white,
  picture: null,
  wrap: ['repeat', 'repeat'],
  scale: [1, 1],
  offset: [0, 0],
} as const;

/** A material with the path of its file. */
interface Described extends MtlMaterial {
  library: string;
}

/** The libraries of an OBJ file, and what is wrong with them. */
class Libraries {
  /** The first of each name counts. */
  readonly materials = new Map<string, Described>();
  private readonly missing: string[] = [];
  private readonly unread: string[] = [];

  constructor(
    lines: readonly string[],
    private readonly companions: Companions,
  ) {
    for (const line of lines) {
      const found = namesOfLine(line).flatMap((name) => companions.find(name) ?? []);
      if (found.length === 0) this.missing.push(line);
      found.forEach((file) => this.take(file));
    }
  }

  private take({ name, bytes }: ModelFile): void {
    const materials = readMtl(bytes);
    if (materials.length === 0) this.unread.push(name);
    for (const material of materials) {
      // What a library names belongs to the model, whether a face uses it or not.
      if (material.picture) this.companions.find(material.picture.path, name);
      if (this.materials.has(material.name)) continue;
      this.materials.set(material.name, { ...material, library: name });
    }
  }

  /** @param names that faces call their materials by */
  noticesFor(names: readonly string[]): Message[] {
    const { materials, missing, unread } = this;
    const notices: Message[] = [];
    if (missing.length > 0) {
      notices.push(notice('missing-looks', { what: 'libraries', files: missing }));
    }
    if (unread.length > 0) notices.push(notice('unread-libraries', { files: unread }));
    const unknown = names.filter((name) => !materials.has(name.trim()));
    if (materials.size > 0 && unknown.length > 0) {
      notices.push(notice('unknown-materials', { names: unknown }));
    }
    return notices;
  }
}

/** Pictures replace the colour of their material, as programs leave that at grey or black then. */
function materialOf(
  name: string,
  described: Described | undefined,
  pictures: Pictures,
  companions: Companions,
): Material {
  if (!described) return { ...plain, name };
  const { library, picture } = described;
  const colour = described.colour ?? white;
  if (!picture) return { ...plain, name, colour };
  const { path, wrap, scale, offset } = picture;
  const file = companions.find(path, library);
  const number = pictures.add(file?.name ?? path, path, () => file);
  if (number === null) return { ...plain, name, colour };
  return { name, colour: white, picture: number, wrap: [wrap, wrap], scale, offset };
}

/** Of an OBJ file, by the names of its materials and libraries. */
function objLooks({ materialNames, libraries }: EngineLooks, companions: Companions): FileLooks {
  const found = new Libraries(libraries, companions);
  const pictures = new Pictures();
  const materials = materialNames.map((name) =>
    materialOf(name, found.materials.get(name.trim()), pictures, companions),
  );
  const notices = [...found.noticesFor(materialNames), ...pictures.notices];
  return { materials, pictures: pictures.files, isForAll: false, notices };
}

/** Of pictures by their names, which faces have the numbers of, or which all have the first of. */
function picturesLooks(
  names: readonly string[],
  isForAll: boolean,
  companions: Companions,
): FileLooks {
  const pictures = new Pictures();
  const materials = names.map((name): Material => {
    return { ...plain, name, picture: pictures.add(name, name, () => companions.find(name)) };
  });
  return { materials, pictures: pictures.files, isForAll, notices: pictures.notices };
}

const pictureEnding = /\.(?:png|jpe?g|gif|webp|bmp|tga)$/i;

/**
 * The only picture beside a model that has places in pictures, but names none: programs write such files when they are
 * told to leave materials out. Null if there is none, or several.
 */
function onlyPicture({ surface, libraries }: EngineLooks, companions: Companions): string | null {
  if (!surface.places || libraries.length > 0) return null;
  const pictures = companions.paths.filter((path) => pictureEnding.test(path));
  return pictures.length === 1 ? pictures[0]! : null;
}

function guessedLooks(picture: string, companions: Companions): FileLooks {
  const looks = picturesLooks([picture], true, companions);
  const told = notice('picture-guessed', { file: picture });
  return looks.pictures.length > 0 ? { ...looks, notices: [told] } : looks;
}

/** @param model as the engine has read it */
export function fileLooks(
  model: ModelFile,
  engine: EngineLooks,
  companions: Companions,
): FileLooks {
  const named = plyPictures(model.bytes);
  if (named.length > 0) return picturesLooks(named, !engine.surface.materials, companions);
  const only = onlyPicture(engine, companions);
  return only === null ? objLooks(engine, companions) : guessedLooks(only, companions);
}
