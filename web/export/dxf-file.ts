/**
 * The frame of a DXF file of release 2000 (AC1015) around its layers and entities. That release asks
 * for more than lines: tables, blocks and an object dictionary, all with handles, without which
 * AutoCAD refuses a file that others read.
 */

/** A group code and its value. */
export type Pair = readonly [code: number, value: string | number];

export interface DxfLayer {
  name: string;
  /** Of AutoCAD's colour index: 1 red, 3 green, 5 blue, 6 magenta, 7 black or white. */
  colour: number;
}

/** One entity: its type, its layer, and what follows the handle and the layer. */
export interface DxfEntity {
  type: 'LINE' | 'LWPOLYLINE';
  layer: string;
  pairs: Pair[];
}

export interface DxfDrawing {
  /** Of the drawing from its lower left; mm. */
  width: number;
  height: number;
  layers: readonly DxfLayer[];
  entities: readonly DxfEntity[];
}

// Lengths are millimetres, and the drawing is metric.
const [millimetres, metric] = [4, 1];

// Names that every reader knows.
const [modelSpace, paperSpace] = ['*Model_Space', '*Paper_Space'];

/** What every entity class calls itself. */
const subclasses = { LINE: 'AcDbLine', LWPOLYLINE: 'AcDbPolyline' } as const;

/** An entry of a table. */
interface TableEntry {
  /** Its class. */
  own: string;
  /** What follows its handle. */
  pairs: Pair[];
  handle?: string;
}

/** The name of an entry, that nothing is special about it, and what else it says. */
function named(name: string, pairs: readonly Pair[] = []): Pair[] {
  return [[2, name], [70, 0], ...pairs];
}

/** A line type without a description and without dashes. */
const solidLine: readonly Pair[] = [
  [3, ''],
  [72, 65],
  [73, 0],
  [40, 0],
];

/** A style of no texts: of any height, upright, in the font that is always there. */
const plainText: readonly Pair[] = [
  [40, 0],
  [41, 1],
  [50, 0],
  [71, 0],
  [42, 2.5],
  [3, 'txt'],
  [4, ''],
];

/** Gives handles, in order, and writes what refers to them. */
class DxfWriter {
  private lastHandle = 0;
  private readonly modelRecord = this.handle();
  private readonly paperRecord = this.handle();
  private readonly dictionary = this.handle();

  private handle(): string {
    return (++this.lastHandle).toString(16).toUpperCase();
  }

  private section(name: string, pairs: Pair[]): Pair[] {
    return [[0, 'SECTION'], [2, name], ...pairs, [0, 'ENDSEC']];
  }

  private header({ width, height }: DxfDrawing): Pair[] {
    const point = (name: string, x: number, y: number): Pair[] => [
      [9, name],
      [10, x],
      [20, y],
      ...(name.startsWith('$EXT') ? [[30, 0] as const] : []),
    ];
    return this.section('HEADER', [
      [9, '$ACADVER'],
      [1, 'AC1015'],
      // Above all that are given out by then.
      [9, '$HANDSEED'],
      [5, (this.lastHandle + 1).toString(16).toUpperCase()],
      [9, '$DWGCODEPAGE'],
      [3, 'ANSI_1252'],
      [9, '$INSUNITS'],
      [70, millimetres],
      [9, '$MEASUREMENT'],
      [70, metric],
      ...point('$EXTMIN', 0, 0),
      ...point('$EXTMAX', width, height),
      ...point('$LIMMIN', 0, 0),
      ...point('$LIMMAX', width, height),
    ]);
  }

  private table(name: string, records: readonly TableEntry[]): Pair[] {
    const table = this.handle();
    const handleCode = name === 'DIMSTYLE' ? 105 : 5;
    return [
      [0, 'TABLE'],
      [2, name],
      [5, table],
      [330, 0],
      [100, 'AcDbSymbolTable'],
      [70, records.length],
      ...(name === 'DIMSTYLE' ? [[100, 'AcDbDimStyleTable'] as const] : []),
      ...records.flatMap(({ own, pairs, handle = this.handle() }): Pair[] => [
        [0, name],
        [handleCode, handle],
        [330, table],
        [100, 'AcDbSymbolTableRecord'],
        [100, own],
        ...pairs,
      ]),
      [0, 'ENDTAB'],
    ];
  }

  /** The whole sheet in the window. */
  private viewport({ width, height }: DxfDrawing): Pair[] {
    return named('*Active', [
      [10, 0],
      [20, 0],
      [11, 1],
      [21, 1],
      [12, width / 2],
      [22, height / 2],
      [40, height],
      [41, width / height],
    ]);
  }

  private blockRecords(): TableEntry[] {
    const blocks = [
      [modelSpace, this.modelRecord],
      [paperSpace, this.paperRecord],
    ] as const;
    return blocks.map(([name, handle]) => ({
      own: 'AcDbBlockTableRecord',
      pairs: [[2, name]],
      handle,
    }));
  }

  private tables(drawing: DxfDrawing): Pair[] {
    const viewport = { own: 'AcDbViewportTableRecord', pairs: this.viewport(drawing) };
    const lineTypes = ['ByBlock', 'ByLayer', 'Continuous'].map((name) => ({
      own: 'AcDbLinetypeTableRecord',
      pairs: named(name, solidLine),
    }));
    const layers = [{ name: '0', colour: 7 }, ...drawing.layers].map(({ name, colour }) => ({
      own: 'AcDbLayerTableRecord',
      pairs: named(name, [
        [62, colour],
        [6, 'Continuous'],
      ]),
    }));
    const textStyle = { own: 'AcDbTextStyleTableRecord', pairs: named('Standard', plainText) };
    return this.section('TABLES', [
      ...this.table('VPORT', [viewport]),
      ...this.table('LTYPE', lineTypes),
      ...this.table('LAYER', layers),
      ...this.table('STYLE', [textStyle]),
      ...this.table('VIEW', []),
      ...this.table('UCS', []),
      ...this.table('APPID', [{ own: 'AcDbRegAppTableRecord', pairs: named('ACAD') }]),
      ...this.table('DIMSTYLE', [{ own: 'AcDbDimStyleTableRecord', pairs: named('Standard') }]),
      ...this.table('BLOCK_RECORD', this.blockRecords()),
    ]);
  }

  private block(name: string, record: string): Pair[] {
    const part = (type: string, own: string, pairs: Pair[]): Pair[] => [
      [0, type],
      [5, this.handle()],
      [330, record],
      [100, 'AcDbEntity'],
      [8, '0'],
      [100, own],
      ...pairs,
    ];
    const begin: Pair[] = [
      [2, name],
      [70, 0],
      [10, 0],
      [20, 0],
      [30, 0],
      [3, name],
      [1, ''],
    ];
    return [...part('BLOCK', 'AcDbBlockBegin', begin), ...part('ENDBLK', 'AcDbBlockEnd', [])];
  }

  private entity({ type, layer, pairs }: DxfEntity): Pair[] {
    return [
      [0, type],
      [5, this.handle()],
      [330, this.modelRecord],
      [100, 'AcDbEntity'],
      [8, layer],
      [100, subclasses[type]],
      ...pairs,
    ];
  }

  private objects(): Pair[] {
    const groups = this.handle();
    return this.section('OBJECTS', [
      [0, 'DICTIONARY'],
      [5, this.dictionary],
      [330, 0],
      [100, 'AcDbDictionary'],
      [281, 1],
      [3, 'ACAD_GROUP'],
      [350, groups],
      [0, 'DICTIONARY'],
      [5, groups],
      [330, this.dictionary],
      [100, 'AcDbDictionary'],
      [281, 1],
    ]);
  }

  write(drawing: DxfDrawing): Pair[] {
    const content = [
      ...this.section('CLASSES', []),
      ...this.tables(drawing),
      ...this.section('BLOCKS', [
        ...this.block(modelSpace, this.modelRecord),
        ...this.block(paperSpace, this.paperRecord),
      ]),
      ...this.section(
        'ENTITIES',
        drawing.entities.flatMap((entity) => this.entity(entity)),
      ),
      ...this.objects(),
    ];
    return [...this.header(drawing), ...content, [0, 'EOF']];
  }
}

/** Codes whose values are real numbers, which programs of old want with a decimal point. */
function isReal(code: number): boolean {
  return code >= 10 && code <= 59;
}

/** The 0.1 micrometre that four decimals keep is far below what any machine resolves. */
function written([code, value]: Pair): string {
  if (typeof value === 'string' || !isReal(code)) return `${code}\n${value}\n`;
  const digits = String(Number(value.toFixed(4)) + 0);
  return `${code}\n${digits.includes('.') ? digits : `${digits}.0`}\n`;
}

/** A drawing as the text of a DXF file; the same drawing gives the same text. */
export function dxfText(drawing: DxfDrawing): string {
  return new DxfWriter().write(drawing).map(written).join('');
}
