/** English phrases for what is told of archives and of glTF, 3MF and Pepakura files. */
import type { FileExcess } from '../../model/model-files.js';
import type { FoldEntryFault, Messages, Table } from '../messages.js';
import { shown } from '../speech.js';
import { all, choose, count, figure, some } from './numbers.js';

/** What is too much of some files, to be read after "it has". */
export function excess(fault: FileExcess): string {
  return fault.what === 'too-many'
    ? `more than ${figure(fault.most)} files`
    : `${figure(fault.megabytes)} MB, and ${figure(fault.most)} MB can be read`;
}

const again = 'get the file once more, or export it again';

function badArchive(params: Messages['bad-archive']): string {
  const file = shown(params.file);
  switch (params.what) {
    case 'damaged':
      return `the archive '${file}' is damaged or cut off; download it again`;
    case 'bomb':
      return `the archive '${file}' would unpack to hundreds of times its size, as no model does; it was not unpacked`;
    case 'locked':
      return `'${shown(params.entry)}' in the archive '${file}' is locked with a password; unpack it yourself and choose the model`;
    case 'method':
      return `'${shown(params.entry)}' in the archive '${file}' is packed in a way that is not read; unpack it yourself and choose the model`;
    case 'too-many':
    case 'too-large':
      return `the archive '${file}' is too large: it has ${excess(params)}; unpack it and choose the model and what belongs to it`;
  }
}

/** What is wrong with an entry of a list, to be read after its name. */
function foldEntry(params: FoldEntryFault): string {
  switch (params.what) {
    case 'number':
      return 'is no number';
    case 'letter':
      return 'is none of B, M, V and F';
    case 'numbers':
      return `is no list of ${figure(params.width)} numbers`;
    case 'list':
      return `is no list of ${figure(params.least)} or more numbers`;
    case 'index':
      return `is the number ${figure(params.index)}, where only 0 to ${figure(params.count - 1)} are there`;
    case 'twice':
      return `is face ${figure(params.index)}, which is in a net already`;
  }
}

function badFold(params: Messages['bad-fold']): string {
  const file = shown(params.file);
  const damaged = `'${file}' is damaged: `;
  switch (params.what) {
    case 'pattern':
      return `'${file}' has only a flat crease pattern, and the folded model is missing; save it with its folded form (“foldedForm”)`;
    case 'flat':
      return `the folded form in '${file}' is flat, and only models with height, width and depth can be unfolded`;
    case 'nothing':
      return `'${file}' is a FOLD file without a model: the folded form (“foldedForm”) is missing; ${again}`;
    case 'cut-off':
      return `'${file}' is cut off: its end is missing; ${again}`;
    case 'no-object':
      return `'${file}' is no FOLD file, whatever its name says; ${again}`;
    case 'word':
      return `${damaged}in line ${figure(params.line)}, at character ${figure(params.character)}, stands '${shown(params.word)}' where something else is expected; ${again}`;
    case 'no-frame':
      return `${damaged}frame ${figure(params.frame)} holds something else than fields; ${again}`;
    case 'missing':
      return `${damaged}in frame ${figure(params.frame)} '${params.key}' is missing; ${again}`;
    case 'type':
      return `${damaged}in frame ${figure(params.frame)} '${params.key}' holds something else than it should; ${again}`;
    case 'times':
      return `${damaged}in frame ${figure(params.frame)} the times in '${params.key}' do not rise from 0 to 1; ${again}`;
    case 'length':
      return `${damaged}in frame ${figure(params.frame)} '${params.key}' has ${count(params.length, 'entry', 'entries')} where ${figure(params.expected)} are expected; ${again}`;
    default:
      return `${damaged}in frame ${figure(params.frame)} entry ${figure(params.entry)} of '${params.key}' ${foldEntry(params)}; ${again}`;
  }
}

function badGltf(params: Messages['bad-gltf']): string {
  const file = shown(params.file);
  switch (params.what) {
    case 'truncated':
      return `'${file}' ends before its data does; ${again}`;
    case 'json':
      return `'${file}' has no readable description of its scene (JSON); ${again}`;
    case 'structure':
      return `'${file}' is damaged: its parts refer to data that is not there or cannot be decoded; ${again}`;
    case 'cycle':
      return `the scene of '${file}' has nodes that hold each other without end; export it again`;
    case 'version': {
      const version = params.version === '' ? 'no version' : `version ${shown(params.version)}`;
      return `'${file}' is glTF of ${version}, and version 2 is read; export it again`;
    }
    case 'extension':
      return `'${file}' stores its shape in a way that is not read (${shown(params.extension)}); export it without that`;
    case 'short-buffer': {
      const bytes = `${figure(params.bytes)} of ${figure(params.announced)} bytes`;
      const where =
        params.buffer === ''
          ? `'${file}' has`
          : `'${shown(params.buffer)}', which '${file}' needs, has`;
      return `${where} only ${bytes} of its data; ${again}`;
    }
  }
}

function bad3mf(params: Messages['bad-3mf']): string {
  const file = shown(params.file);
  switch (params.what) {
    case 'no-model':
      return `'${file}' is a 3MF package without a model in it; ${again}`;
    case 'nothing':
      return `'${file}' has nothing that is to be printed; save the project again with a visible object in it`;
    case 'sliced':
      return `'${file}' holds only a sliced print job (G-code) and no model any more; save the project itself, not the sliced file`;
    case 'no-part':
      return `'${file}' refers to '${shown(params.part)}', which is not in it; ${again}`;
    case 'no-object':
      return `'${file}' refers to object ${shown(params.object)} in '${shown(params.part)}', which is not there; ${again}`;
    case 'cycle':
      return `object ${shown(params.object)} in '${file}' holds itself, or far too many others; export it again`;
    case 'xml':
      return `'${file}' is damaged: '${shown(params.part)}' is no XML at line ${figure(params.line)}; ${again}`;
    case 'word':
      return `'${file}' is damaged: at line ${figure(params.line)} of '${shown(params.part)}' stands '${shown(params.word)}' where something else is expected; ${again}`;
  }
}

function badPdo(params: Messages['bad-pdo']): string {
  const file = shown(params.file);
  switch (params.what) {
    case 'locked':
      return `'${file}' is locked by the person who made it; ask that person for a file without a lock`;
    case 'hidden':
      return `in '${file}' all bodies are switched off; switch one on in Pepakura Designer, and save it again`;
    case 'no-faces':
      return `'${file}' is a Pepakura file without a face that could be folded; ${again}`;
    case 'old':
      return `'${file}' is of the first Pepakura Designer, and files of Pepakura Designer 2 to 6 are read; open it in one of these, and save it again`;
    case 'version':
      return `'${file}' is of a version of Pepakura that is not known here (${figure(params.version)}); save it for Pepakura Designer 2 to 6, or as OBJ`;
    case 'damaged':
      return `'${file}' is damaged or cut off (byte ${figure(params.at)}); get the file once more, or save it again in Pepakura Designer`;
  }
}

/** Those kinds that there are: "3 animations and 2 cameras". */
function kinds(counts: readonly (readonly [number, string, string?])[]): string {
  const found = counts.filter(([number]) => number > 0);
  return all(found.map(([number, one, many]) => count(number, one, many)));
}

function missingLooks({ what, files }: Messages['missing-looks']): string {
  const [is, them] = [choose(files.length, 'is', 'are'), choose(files.length, 'it', 'them')];
  const names = some(files);
  const those =
    what === 'pictures'
      ? `${choose(files.length, 'the picture', 'the pictures')} ${names}`
      : `${choose(files.length, 'the file', 'the files')} with the model's colours and pictures, ${names},`;
  return (
    `${those} ${is} missing, so those faces stay plain; ` +
    `choose ${them} as well, or choose the whole folder`
  );
}

function unreadPictures({ files, kinds }: Messages['unread-pictures']): string {
  const are = choose(files.length, 'is', 'are');
  const what =
    kinds.length > 0
      ? `${are} of a kind that is not read (${all(kinds)})`
      : `${are} no ${choose(files.length, 'picture', 'pictures')} that can be read`;
  const saved = choose(files.length, 'it', 'them');
  return `${some(files)} ${what}; save ${saved} as PNG or JPEG, and name ${saved} so in the model`;
}

const lostNets = {
  none: 'the file brings no nets of its own',
  simplified: 'the nets of the file do not fit a model with other triangles',
  repaired: 'the nets of the file could not be kept, as its faces had to be repaired',
  flat: 'the nets of the file could not be kept, as they run through flat faces',
} as const;

function keptNets({ pieces, uncut, size }: Messages['file-nets-kept']): string {
  const words = [
    pieces === 1
      ? 'the net of the file was kept'
      : `the ${figure(pieces)} nets of the file were kept`,
  ];
  if (size === 'file') words.push('at the size of the file');
  if (uncut > 0) {
    words.push(
      `but ${count(uncut, 'cut')} within flat faces ${choose(uncut, 'was', 'were')} left out`,
    );
  }
  return words.join(', ');
}

export const readerMessages = {
  'bad-3mf': bad3mf,
  'bad-archive': badArchive,
  'bad-fold': badFold,
  'bad-gltf': badGltf,
  'bad-pdo': badPdo,
  'missing-files': ({ file, missing }) =>
    `'${shown(file)}' needs ${some(missing)}, which ${choose(missing.length, 'is', 'are')} missing; ` +
    `choose ${choose(missing.length, 'it', 'them')} as well, or choose the whole folder`,
  'no-model-in-archive': ({ file, files }) =>
    files.length === 0
      ? `there is nothing in the archive '${shown(file)}'`
      : `no file in the archive '${shown(file)}' is a model that is read; it has ${some(files)}`,
  'reader-not-loaded': () =>
    'the reader of this format could not be loaded; look to the connection, and try once more',
  'uniter-not-loaded': () =>
    'what unites bodies could not be loaded; look to the connection, and try once more',
  'too-many-triangles': ({ most }) =>
    `the model has more than ${figure(most)} triangles, which is more than can be read; ` +
    'simplify it in the program that made it',

  'broken-faces': ({ count: number }) =>
    `${count(number, 'face')} left out: ${choose(number, 'it lacks', 'they lack')} corners, or ${choose(number, 'names', 'name')} vertices that are not in the file`,
  'damaged-extras': () =>
    'behind its shape the file is damaged: some colours, pictures and the nets of the file are lost; save it again in Pepakura Designer',
  'damaged-looks': () =>
    'the colours and pictures in the file are damaged: only its shape was read; export it again',
  'large-pictures': ({ files, most, most_mb, most_pixels }) =>
    `${some(files)} ${choose(files.length, 'was', 'were')} left out: up to ${figure(most)} pictures of ` +
    `${figure(most_mb)} MB together can be used, each of ${figure(most_pixels / 1e6, 0)} million pixels at most; ` +
    `make ${choose(files.length, 'it', 'them')} smaller in a program for pictures`,
  'lost-looks': ({ count: number }) =>
    `${count(number, 'colour or picture', 'colours or pictures')} that the model refers to ${choose(number, 'is', 'are')} ` +
    'not in the file, so those faces stay white; export it again',
  'missing-looks': missingLooks,
  'picture-guessed': ({ file }) =>
    `the model names no picture, so ${shown(file)} was laid on it, the only one beside it`,
  'simplified-looks': () =>
    'where the file lays colours or pictures over each other or mixes them, the topmost picture is taken, ' +
    'or else the main colour',
  'unknown-materials': ({ names }) =>
    `the model's ${choose(names.length, 'material', 'materials')} ${some(names)} ${choose(names.length, 'is', 'are')} ` +
    'in none of its MTL files, so what is made of it stays white',
  'unread-libraries': ({ files }) =>
    `${some(files)}, which should describe the model's colours and pictures, ${choose(files.length, 'is', 'are')} damaged ` +
    'or no MTL file; export the model again',
  'unread-pictures': unreadPictures,

  'archive-choice': ({ file, others }) =>
    `the archive has ${figure(others.length + 1)} models; '${shown(file)}' was taken, and not ${some(others)}`,
  'not-for-printing': ({ supports, modifiers, negatives, unprinted }) =>
    `left out, as the file says that they are not printed: ${kinds([
      [supports, 'support'],
      [modifiers, 'modifier'],
      [negatives, 'negative part'],
      [unprinted, 'object that is switched off', 'objects that are switched off'],
    ])}`,
  'file-nets-kept': keptNets,
  'file-nets-lost': ({ what }) => `${lostNets[what]}, so new ones were made`,
  'file-nets-unused': ({ pieces }) =>
    `the file brings ${count(pieces, 'net')} of its own; new ones were made; to keep ${choose(pieces, 'it', 'them')}, choose that when the model is checked (--nets file)`,
  'fold-nets-unused': ({ pieces }) =>
    `the file brings ${count(pieces, 'net')} of its own, which ${choose(pieces, 'was', 'were')} not used: its folded model was unfolded anew`,
  'parts-unused': ({ parts }) =>
    `${count(parts, 'part')} ${choose(parts, 'was', 'were')} asked for, but the nets of the file have parts of their own, which were kept`,
  'pdo-unused': ({ hidden, texts, images }) =>
    `not used: ${kinds([
      [hidden, 'body that is switched off', 'bodies that are switched off'],
      [texts, 'text on the sheets', 'texts on the sheets'],
      [images, 'picture on the sheets', 'pictures on the sheets'],
    ])}`,
  'posed-skins': ({ count: number }) =>
    `${count(number, 'mesh', 'meshes')} with a skeleton ${choose(number, 'stands', 'stand')} in the pose that the file begins with`,
  'unknown-extensions': ({ names }) =>
    `the file uses ${some(names)}, which ${choose(names.length, 'is', 'are')} not known here; something may be missing or look different`,
  'unused-content': ({ animations, morphs, uvs, cameras, instances }) =>
    `not used: ${kinds([
      [animations, 'animation'],
      [morphs, 'morph target'],
      [uvs, 'second set of texture coordinates', 'second sets of texture coordinates'],
      [cameras, 'camera'],
      [instances, 'group of copies', 'groups of copies'],
    ])}`,
} satisfies Partial<Table>;
