import type { KnownMessage } from '../../web/words/messages.js';

/**
 * One for each sentence of a code that has several, and for each form of a plural. The file is longer than others: it
 * is this one table.
 */
export const examples: readonly [KnownMessage, string][] = [
  [
    { code: 'run-stopped', params: {} },
    'the search was stopped before its end, and what was found until then is here; unfold again to let it finish',
  ],
  [
    { code: 'overlapping-pieces', params: { pieces: ['B'] } },
    'piece B overlaps itself and cannot be cut out whole',
  ],
  [
    { code: 'overlapping-pieces', params: { pieces: ['B', 'C'] } },
    'pieces B, C overlap themselves and cannot be cut out whole',
  ],
  [
    { code: 'missing-names', params: { pieces: ['B'] } },
    'no room for its name on piece B; short names need less',
  ],
  [
    { code: 'equal-pieces', params: { pieces: [...'ADFG'] } },
    'the same piece is needed 4 times: pieces A, D, F, G',
  ],
  [
    { code: 'missing-names', params: { pieces: [...'ABCDEFGHIJKLMNO'] } },
    'no room for their names on pieces A, B, C, D, E, F, G, H, I, J, K, L and 3 more; short names need less',
  ],
  [
    { code: 'empty-sheet', params: { sheet: 4, percent: 0, pieces: [] } },
    'the last sheet, number 4, is almost empty: less than 1 % of it is used, by loose strips',
  ],
  [
    { code: 'short-seams', params: { median_mm: 2.04, depth: 260 } },
    'half of the seams are at most 2 mm long, which is hard to glue; easier to build: 260 mm deep (--depth 260)',
  ],
  [
    { code: 'bad-archive', params: { file: 'a.zip', what: 'locked', entry: 'b/c.obj' } },
    "'b/c.obj' in the archive 'a.zip' is locked with a password; unpack it yourself and choose the model",
  ],
  [
    {
      code: 'bad-gltf',
      params: { file: 'a.gltf', what: 'short-buffer', buffer: 'a.bin', bytes: 7, announced: 90 },
    },
    "'a.bin', which 'a.gltf' needs, has only 7 of 90 bytes of its data; get the file once more, or export it again",
  ],
  [
    {
      code: 'bad-fold',
      params: {
        file: 'a.fold',
        what: 'index',
        frame: 1,
        key: 'faces_vertices',
        entry: 4,
        index: 99,
        count: 8,
      },
    },
    "'a.fold' is damaged: in frame 1 entry 4 of 'faces_vertices' is the number 99, where only 0 to 7 are there; get the file once more, or export it again",
  ],
  [
    {
      code: 'bad-fold',
      params: { file: 'a.fold', what: 'word', line: 8, character: 120, word: 'nan' },
    },
    "'a.fold' is damaged: in line 8, at character 120, stands 'nan' where something else is expected; get the file once more, or export it again",
  ],
  [
    { code: 'bad-fold', params: { file: 'a.fold', what: 'pattern' } },
    "'a.fold' has only a flat crease pattern, and the folded model is missing; save it with its folded form (“foldedForm”)",
  ],
  [{ code: 'edit-place-gone', params: { what: 'edge' } }, 'there is no such edge there any more'],
  [
    { code: 'fold-nets-unused', params: { pieces: 1 } },
    'the file brings 1 net of its own, which was not used: its folded model was unfolded anew',
  ],
  [
    {
      code: 'bad-3mf',
      params: { file: 'a.3mf', what: 'word', part: '3D/a.model', line: 8, word: 'nan' },
    },
    "'a.3mf' is damaged: at line 8 of '3D/a.model' stands 'nan' where something else is expected; get the file once more, or export it again",
  ],
  [
    { code: 'bad-pdo', params: { file: 'a.pdo', what: 'damaged', at: 120 } },
    "'a.pdo' is damaged or cut off (byte 120); get the file once more, or save it again in Pepakura Designer",
  ],
  [
    { code: 'bad-pdo', params: { file: 'a.pdo', what: 'version', version: 9 } },
    "'a.pdo' is of a version of Pepakura that is not known here (9); save it for Pepakura Designer 2 to 6, or as OBJ",
  ],
  [
    { code: 'broken-faces', params: { count: 1 } },
    '1 face left out: it lacks corners, or names vertices that are not in the file',
  ],
  [
    { code: 'pdo-unused', params: { hidden: 1, texts: 3, images: 0 } },
    'not used: 1 body that is switched off and 3 texts on the sheets',
  ],
  [
    { code: 'missing-files', params: { file: 'a.gltf', missing: ['a.bin'] } },
    "'a.gltf' needs a.bin, which is missing; choose it as well, or choose the whole folder",
  ],
  [
    { code: 'no-model-in-archive', params: { file: 'a.zip', files: [] } },
    "there is nothing in the archive 'a.zip'",
  ],
  [
    { code: 'damaged-looks', params: {} },
    'the colours and pictures in the file are damaged: only its shape was read; export it again',
  ],
  [
    {
      code: 'large-pictures',
      params: { files: ['a.png'], most: 256, most_mb: 64, most_pixels: 2 ** 26 },
    },
    'a.png was left out: up to 256 pictures of 64 MB together can be used, each of 67 million pixels at most; make it smaller in a program for pictures',
  ],
  [
    { code: 'lost-looks', params: { count: 2 } },
    '2 colours or pictures that the model refers to are not in the file, so those faces stay white; export it again',
  ],
  [
    { code: 'missing-looks', params: { what: 'pictures', files: ['a.png', 'b.png'] } },
    'the pictures a.png and b.png are missing, so those faces stay plain; choose them as well, or choose the whole folder',
  ],
  [
    { code: 'missing-looks', params: { what: 'libraries', files: ['a.mtl'] } },
    "the file with the model's colours and pictures, a.mtl, is missing, so those faces stay plain; choose it as well, or choose the whole folder",
  ],
  [
    { code: 'picture-guessed', params: { file: 'a.png' } },
    'the model names no picture, so a.png was laid on it, the only one beside it',
  ],
  [
    { code: 'simplified-looks', params: {} },
    'where the file lays colours or pictures over each other or mixes them, the topmost picture is taken, or else the main colour',
  ],
  [
    { code: 'unknown-materials', params: { names: ['wood'] } },
    "the model's material wood is in none of its MTL files, so what is made of it stays white",
  ],
  [
    { code: 'unread-libraries', params: { files: ['a.mtl'] } },
    "a.mtl, which should describe the model's colours and pictures, is damaged or no MTL file; export the model again",
  ],
  [
    { code: 'unread-pictures', params: { files: ['a.tga', 'b.dds'], kinds: ['TGA', 'DDS'] } },
    'a.tga and b.dds are of a kind that is not read (TGA and DDS); save them as PNG or JPEG, and name them so in the model',
  ],
  [
    { code: 'unread-pictures', params: { files: ['a.png'], kinds: [] } },
    'a.png is no picture that can be read; save it as PNG or JPEG, and name it so in the model',
  ],
  [
    { code: 'archive-choice', params: { file: 'a.obj', others: ['b/c.obj', 'b/d.obj'] } },
    "the archive has 3 models; 'a.obj' was taken, and not b/c.obj and b/d.obj",
  ],
  [
    {
      code: 'not-for-printing',
      params: { supports: 1, modifiers: 0, negatives: 2, unprinted: 1 },
    },
    'left out, as the file says that they are not printed: 1 support, 2 negative parts and 1 object that is switched off',
  ],
  [
    {
      code: 'unused-content',
      params: { animations: 3, morphs: 1, uvs: 0, cameras: 0, instances: 0 },
    },
    'not used: 3 animations and 1 morph target',
  ],
  [{ code: 'no-looks', params: {} }, 'the model has no colours or pictures that could be printed'],
  [
    { code: 'pictures-unreadable', params: { what: 'format', files: ['a.tga'] } },
    'a.tga is no PNG, JPEG or GIF picture: its faces have the colour of their material',
  ],
  [
    { code: 'pictures-unreadable', params: { what: 'damaged', files: ['a.png', 'b.png'] } },
    'a.png and b.png are damaged, or nothing can be seen on them: their faces have the colour of their material',
  ],
  [
    { code: 'pictures-unreadable', params: { what: 'large', files: ['a.png'] } },
    'a.png is too large, save it with fewer pixels: its faces have the colour of their material',
  ],
  [
    { code: 'pictures-not-loaded', params: {} },
    'what reads pictures could not be loaded: faces have the colours of their materials',
  ],
  [
    { code: 'marks-not-free', params: { pieces: ['A', 'C'], margin_mm: 30 } },
    'the machine looks for its marks where something is cut: a margin of 30 mm keeps them free; pieces A, C',
  ],
  [
    {
      code: 'cricut-area',
      params: { sheets: [1, 3], width_mm: 182.6, height_mm: 269.6, margin_mm: 14 },
    },
    'Cricut prints and then cuts 182 x 269 mm of this paper at most, and sheets 1 and 3 need more: ' +
      'cut without printing, or choose a margin of 14 mm',
  ],
  [
    {
      code: 'cricut-area',
      params: { sheets: [2], width_mm: 182.6, height_mm: 269.6, margin_mm: 14 },
    },
    'Cricut prints and then cuts 182 x 269 mm of this paper at most, and sheet 2 needs more: ' +
      'cut without printing, or choose a margin of 14 mm',
  ],
  [
    { code: 'small-bodies', params: { count: 24, faces: 288, limit_mm: 4 } },
    '24 bodies of the model are smaller than 4 mm and were left out',
  ],
  [
    {
      code: 'smaller-saves-sheets',
      params: { what: 'height', size_mm: 148, instead_mm: 150.2, sheets: 1, of: 2 },
    },
    'with a height of 148 mm instead of 150 it should go on 1 sheet instead of 2',
  ],
  [
    {
      code: 'bad-index',
      params: { place: 'line', at: 6, what: 'beyond', index: 99, vertices: 4, first: 1 },
    },
    'line 6: face refers to vertex 99, but the file has 4 vertices',
  ],
  [
    {
      code: 'bad-index',
      params: { place: 'line', at: 7, what: 'beyond', index: 3, vertices: 3, first: 0 },
    },
    'line 7: face refers to vertex 3, but the file has 3 vertices, counted from 0',
  ],
  [
    { code: 'bad-index', params: { place: 'line', at: 6, what: 'before', index: -5, vertices: 4 } },
    'line 6: face refers to vertex -5, but only 4 vertices come before it',
  ],
  [
    { code: 'bad-number', params: { place: 'line', at: 2, what: 'comma', word: '1,5,5' } },
    "line 2: '1,5,5' has a comma where none is expected",
  ],
  [
    { code: 'bad-number', params: { place: 'line', at: 5, what: 'whole', word: 'x' } },
    "line 5: 'x' stands where a whole number is expected",
  ],
  [
    { code: 'dropped-misnumbered-faces', params: { count: 1, place: 'line', at: 21 } },
    '1 face was dropped for naming a vertex that the file does not have (line 21)',
  ],
  [
    { code: 'dropped-misnumbered-faces', params: { count: 3, place: 'line', at: 21 } },
    '3 faces were dropped for naming a vertex that the file does not have (the first: line 21)',
  ],
  [
    { code: 'dropped-placeless-faces', params: { count: 6, place: 'line', at: 8 } },
    '6 faces were dropped for a vertex without usable coordinates (line 8)',
  ],
  [
    { code: 'cut-off', params: { count: 19, place: 'line', at: 20 } },
    'line 20: the file ends too early; what stands before, 19 faces, is used',
  ],
  [
    { code: 'decimal-commas', params: { count: 8 } },
    '8 numbers have a comma and were read as if it were a decimal point',
  ],
  [
    { code: 'bad-size', params: { least: 1e-60, most: 1e60 } },
    "the model's size is out of range; 1e-60 to 1e60 is supported",
  ],
  [
    {
      code: 'bad-header',
      params: { what: 'property', element: 'face', property: 'vertex_indices' },
    },
    "element 'face' needs one property 'vertex_indices' that is a list",
  ],
  [
    { code: 'bad-header', params: { what: 'property', element: 'vertex', property: 'y' } },
    "element 'vertex' needs one property 'y'",
  ],
  [
    {
      code: 'truncated',
      params: { what: 'vertices', place: 'line', at: 3, done: 1, announced: 5 },
    },
    'line 3: the file ends after 1 of 5 vertices',
  ],
  [{ code: 'truncated', params: { what: 'header-only' } }, 'the file ends after its header'],
  [
    {
      code: 'truncated',
      params: { what: 'triangles', place: 'triangle', at: 2, announced: 4294967295 },
    },
    'triangle 2: the file ends here, but its header announces 4294967295 triangles',
  ],
  [
    { code: 'unknown-format', params: { what: 'contents', format: 'fbx' } },
    'the file is an FBX model, which is not read; save it as GLB, OBJ, STL, 3MF, PLY or OFF in the program that made it',
  ],
  [
    { code: 'unknown-format', params: { what: 'contents', format: 'png' } },
    'the file is a PNG picture, which is not read; OBJ, STL, OFF, PLY, GLB, glTF, 3MF, PDO and FOLD are',
  ],
  [
    { code: 'unknown-format', params: { what: 'ending', ending: 'pdo' } },
    'the file is named .pdo, but does not begin like one: it is damaged, or of another kind; get it once more, or save it again',
  ],
  [
    { code: 'unknown-format', params: { what: 'ending', ending: 'xyz' } },
    "files that end in '.xyz' are not read; OBJ, STL, OFF, PLY, GLB, glTF, 3MF, PDO and FOLD are",
  ],
  [
    { code: 'lost-picture-places', params: { count: 2 } },
    '2 corners of faces name a place in the picture that the file does not have; these faces show their plain colour',
  ],
  [
    {
      code: 'ignored-elements',
      params: { count: 6, points: 1, lines: 2, curves: 2, surfaces: 1 },
    },
    'ignored, since only faces fold: 1 point element, 2 line elements, 2 free-form curves, 1 free-form surface',
  ],
  [
    { code: 'closed-cracks', params: { count: 2, width: 0.0020000001 } },
    "2 edges were joined to others across cracks, the widest 0.002 of the model's units wide",
  ],
  [
    { code: 'flipped-faces', params: { count: 1 } },
    '1 face was turned over, so that all have the same side outside',
  ],
  [
    { code: 'split-nonmanifold-vertices', params: { count: 2 } },
    '2 vertices where surfaces only touch came apart',
  ],
  [
    { code: 'open-border', params: { count: 1, gap: 0.001, bodies: 1 } },
    "1 edge lies on the border of 1 open surface without a volume, printed as one layer of paper whose plain back can be seen; gaps wider than 0.001 of the model's size, or wide against the edges beside them, are left open",
  ],
  [
    { code: 'open-holes', params: { count: 1, percent: 12.5, small: 0, small_percent: 10 } },
    "1 hole is left open, 12.5 % of the model's longest side across (--fill-holes 12.5 fills it)",
  ],
  [
    { code: 'open-holes', params: { count: 3, percent: 141.5, small: 2, small_percent: 10 } },
    "3 holes are left open, the widest 141.5 % of the model's longest side across (--fill-holes all fills them, --fill-holes 10 the 2 small ones alone)",
  ],
  [
    { code: 'step-off', params: { count: 2, what: 'weld' } },
    'welding was switched off: 2 vertices lie on others and stay apart from them',
  ],
  [
    { code: 'step-off', params: { count: 1, what: 'duplicates' } },
    'dropping copies was switched off: 1 face repeats another one and is printed as well',
  ],
  [
    { code: 'step-off', params: { count: 3, what: 'two-sided' } },
    'joining two sides was switched off: 3 faces lie on the backs of others and are printed as well',
  ],
  [
    { code: 'step-off', params: { count: 1, what: 't-junctions' } },
    'closing gaps at corners was switched off: 1 edge with a corner of the neighbours on it stays open',
  ],
  [
    { code: 'step-off', params: { count: 4, what: 'cracks' } },
    'closing cracks was switched off: 4 edges beside cracks stay open',
  ],
  [
    { code: 'step-off', params: { count: 1, what: 'winding' } },
    'turning faces over was switched off: 1 face has its printed side inside, and comes apart from neighbours that have it outside',
  ],
  [
    { code: 'step-off', params: { count: 6, what: 'flatten' } },
    'flattening was switched off: 6 faces that were drawn flat stay slightly bent',
  ],
  [
    { code: 'flat-bodies', params: { count: 1 } },
    '1 closed body has no volume, since its layers lie on each other: each layer is printed, to be glued back to back into one sheet',
  ],
  [
    { code: 'bad-option', params: { what: 'repair', step: 'polygons' } },
    "'polygons' is a step of the repair that cannot be switched off",
  ],
  [
    { code: 'filled-holes', params: { count: 2 } },
    '2 holes were filled with new faces, in the colours beside them',
  ],
  [
    { code: 'unfilled-holes', params: { count: 1 } },
    '1 hole stays open: every face in it would run through the model or lie on it',
  ],
  [
    { code: 'parts-unused', params: { parts: 6 } },
    '6 parts were asked for, but the nets of the file have parts of their own, which were kept',
  ],
  [
    { code: 'huge-holes', params: { count: 2, edges: 5000 } },
    '2 holes stay open: only holes of at most 5000 edges are filled',
  ],
  [
    { code: 'inner-bodies', params: { count: 2 } },
    '2 bodies lie inside another one, where nobody will see them (--inside drop leaves them out)',
  ],
  [
    { code: 'crossing-bodies', params: { count: 2, unitable: 2 } },
    '2 pairs of bodies run through each other: their pieces would collide when assembled (--crossing unite makes one of them)',
  ],
  [
    { code: 'crossing-bodies', params: { count: 1, unitable: 0 } },
    '1 pair of bodies runs through each other: their pieces would collide when assembled; unite them in the modelling program',
  ],
  [
    { code: 'united-bodies', params: { count: 3, faces: 1 } },
    '3 bodies that ran through each other were united; nothing is left of 1 face inside',
  ],
  [
    { code: 'united-bodies', params: { count: 2, faces: 0 } },
    '2 bodies that ran through each other were united',
  ],
  [
    { code: 'not-united', params: { count: 1, open: 1 } },
    '1 body that runs through others could not be united with them: only what is closed has an inside (--fill-holes all closes it)',
  ],
  [
    { code: 'not-united', params: { count: 3, open: 1 } },
    '3 bodies that run through others could not be united with them; unite them in the modelling program',
  ],
  [
    { code: 'uniter-not-loaded', params: {} },
    'what unites bodies could not be loaded; look to the connection, and try once more',
  ],
  [
    { code: 'dropped-inner-bodies', params: { count: 1, faces: 12 } },
    '1 body (12 faces) was left out, since nobody sees what lies inside another one',
  ],
  [
    { code: 'open-border', params: { what: 'edge' } },
    'only one face has this edge: there is nothing to join there',
  ],
  [
    { code: 'bad-edit', params: { what: 'apart', parts: [1, 2, 5] } },
    'parts 1, 2 and 5 do not touch, so they cannot become one',
  ],
  [
    { code: 'bad-edit', params: { what: 'into', parts: [1], into: 2000000000, most: 12 } },
    'part 1 cannot become 2000000000 parts: from 1 to 12 are possible, one for each flat panel',
  ],
  [
    { code: 'bad-option', params: { what: 'clearance', least: 0.0001, most: 0.2 } },
    'clearance must be from 0.0001 to 0.2',
  ],
  [
    {
      code: 'bad-option',
      params: {
        what: 'value',
        option: 'cutWidth',
        value: '5',
        expected: 'decimal',
        least: 0.01,
        most: 2,
        or: 'style',
      },
    },
    "option 'cutWidth': '5' is not a number from 0.01 to 2, nor style",
  ],
  [
    { code: 'bad-option', params: { what: 'no-option', option: 'colour' } },
    "there is no option 'colour'",
  ],
  [
    { code: 'bad-option', params: { what: 'fixed', option: 'parts' } },
    "option 'parts' cannot be changed here",
  ],
  [
    { code: 'bad-option', params: { what: 'second-size', option: 'width', first: 'height' } },
    "option 'width': the size is given by 'height' already",
  ],
  [
    {
      code: 'bad-option',
      params: { what: 'no-paper-left', option: 'margin', margin_mm: 105, paper: 'A4' },
    },
    "option 'margin': 105 mm leave nothing of A4 paper",
  ],
  [
    {
      code: 'bad-option',
      params: { what: 'pixels', dpi: 1200, width_mm: 420, height_mm: 594.04, possible: 622 },
    },
    '1200 dots per inch are too many for sheets of 420 x 594 mm: 622 are possible',
  ],
  [
    { code: 'bad-option', params: { what: 'height', most: 100000 } },
    'height must be above 0 and at most 100000 mm',
  ],
  [
    { code: 'bad-pin', params: { what: 'overlap', pieces: ['A', 'Wing'], sheet: 1 } },
    'pieces A and Wing are pinned on top of each other on sheet 1',
  ],
  [
    { code: 'colour-numbers', params: {} },
    'the file gives its faces numbers instead of colours, and does not say which colours these are: they are not printed',
  ],
  [{ code: 'files-ignored', params: { files: ['a.mtl'] } }, '1 other file was not needed: a.mtl'],
  [
    { code: 'files-ignored', params: { files: ['a.mtl', 'b.png', 'c.png', 'd.png', 'e.png'] } },
    '5 other files were not needed: a.mtl, b.png, c.png and 2 more',
  ],
  [
    { code: 'several-models', params: { count: 2, first: 'a.obj', second: 'parts/b.obj' } },
    "there are two models among the files: 'a.obj' and 'parts/b.obj'; choose one of them",
  ],
  [
    { code: 'no-model', params: { count: 2 } },
    'none of the 2 files is a model that is read; OBJ, STL, OFF, PLY, GLB, glTF, 3MF, PDO and FOLD are',
  ],
  [
    { code: 'unknown-format', params: { what: 'file', file: 'cube.dae', format: 'dae' } },
    "'cube.dae' is a COLLADA (DAE) model, which is not read; save it as GLB, OBJ, STL, 3MF, PLY or OFF in the program that made it",
  ],
  [
    {
      code: 'face-too-large',
      params: {
        face_width_mm: 400,
        face_height_mm: 400,
        width_mm: 210,
        height_mm: 297,
        share: 0.508,
      },
    },
    'at this size a flat face of 400 x 400 mm is larger than a sheet of 210 x 297 mm: it would fit at 50 % of the size, or on paper 2.0 times as large',
  ],
  [
    { code: 'out-of-memory', params: { what: 'paper' } },
    'there is not enough memory for placing pieces on sheets: choose a smaller size, smaller paper or fewer faces',
  ],
  [
    { code: 'joints', params: { what: 'numbered', count: 1 } },
    '1 edge is glued to faces that it does not continue: look for the same number there',
  ],
  [
    { code: 'joints', params: { what: 'bare', count: 3 } },
    '3 edges are glued to faces that they do not continue',
  ],
  [
    { code: 'large-model', params: { faces: 70000, seconds: 229.4, proposed: 1500 } },
    'the model has 70000 faces: nets for them take about 4 minutes, and most of them will be too small to fold; paper models have a few hundred (--faces 1500 makes a simpler model)',
  ],
  [
    { code: 'large-model', params: { faces: 2400, seconds: 1.7, proposed: 1500 } },
    'the model has 2400 faces: most of them will be too small to fold; paper models have a few hundred (--faces 1500 makes a simpler model)',
  ],
  [
    { code: 'too-many-faces', params: { faces: 120000, most: 100000, proposed: 1500 } },
    'the model has 120000 flat faces, and nets for more than 100000 would take hours and be far too small to fold: --faces 1500 makes a simpler model that can be folded',
  ],
  [
    { code: 'parts-raised', params: { what: 'bodies', bodies: 2 } },
    'the model has 2 separate bodies, so it needs at least as many parts',
  ],
  [
    { code: 'unchecked-pieces', params: { what: 'off', pieces: ['A'] } },
    'no way to fold up piece A was looked for: folding is switched off',
  ],
  [
    { code: 'engine-died', params: { reason: 'gone', times: 3 } },
    'The engine stopped unexpectedly 3 times at the same task: gone',
  ],
  [
    { code: 'bad-project', params: { file: 'a.foldwright', what: 'newer', version: 2 } },
    "'a.foldwright' was saved by a newer Foldwright (its files have version 2); open it with that one",
  ],
  [
    { code: 'bad-project', params: { file: 'a.foldwright', what: 'damaged' } },
    "'a.foldwright' is damaged: the model in it is lost; open an earlier copy of the project",
  ],
  [
    { code: 'project-damaged', params: { what: 'files', files: ['wood.png'] } },
    'the project file is damaged: wood.png, which is part of the model, could not be read',
  ],
  [
    { code: 'project-damaged', params: { what: 'edits', count: 3 } },
    'the project file is damaged: the last 3 changes could not be read',
  ],
  [
    { code: 'project-damaged', params: { what: 'refused', count: 1 } },
    'the last 1 change of the project could not be made again with this model',
  ],
  [
    { code: 'project-options-lost', params: { options: ['glitter'] } },
    'glitter: this setting of the project is not known here, and stayed as usual',
  ],
];
