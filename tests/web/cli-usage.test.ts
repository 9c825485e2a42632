import { mkdirSync, readdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { foldwright, inFolder, isBuilt } from './command.js';

/** What the command line refuses before it looks at a model. */
async function refusal(args: string[]): Promise<string> {
  const { status, stdout, stderr } = await foldwright(['model.obj', ...args]);
  expect(stdout).toBe('');
  expect(stderr).toMatch(/^foldwright: [^\n]+\n$/);
  expect(status).toBe(2);
  return stderr;
}

describe.skipIf(!isBuilt)('the command line', () => {
  it('explains itself', async () => {
    const { status, stdout, stderr } = await foldwright(['--help']);
    expect([status, stderr]).toEqual([0, '']);
    for (const name of ['--parts', '--paper', '--report', '--output', '--quiet']) {
      expect(stdout).toContain(name);
    }
  });

  it('tells its version', async () => {
    const { status, stdout } = await foldwright(['--version']);
    expect(status).toBe(0);
    expect(stdout).toMatch(/^\d+\.\d+\.\d+\n$/);
  });

  it('wants a model', async () => {
    const { status, stderr } = await foldwright([]);
    expect(status).toBe(2);
    expect(stderr).toMatch(/^foldwright: missing required argument 'model'\n$/);
  });

  it.each([
    [['--nonsense'], "unknown option '--nonsense'"],
    [['--parts', 'x'], "option '--parts': 'x' is not a whole number"],
    [['--parts', '0'], "option '--parts': '0' is not"],
    [['--parts', '2.5'], "option '--parts': '2.5' is not"],
    [['--seed', '-1'], "option '--seed': '-1' is not"],
    [['--seed'], "option '--seed <N>' argument missing"],
    [['--runs', '1e3'], "option '--runs': '1e3' is not"],
    [['--heuristic', 'best'], "option '--heuristic': 'best' is not steepest or flat"],
    [['--paper', 'B5'], "option '--paper': 'B5' is neither A2"],
    [['--paper', '0x100'], "option '--paper': '0x100' is neither"],
    [['--margin', '105'], "option '--margin': 105 mm leave nothing of A4 paper"],
    [['--flat-fold', '181'], "option '--flat-fold': '181' is not"],
    [['--solver', 'best'], "option '--solver': 'best' is not tree or genetic"],
    [['--workers', '0'], "option '--workers': '0' is not a whole number from 1 to 64, nor auto"],
    [['--workers', '65'], "option '--workers': '65' is not"],
    [['--folding', 'maybe'], "option '--folding': 'maybe' is not require or prefer or off"],
    [['--clearance', '0.5'], "option '--clearance': '0.5' is not a number from 0.0001 to 0.2"],
    [['--height', '0'], "option '--height': '0' is not a number from 1 to 100000, nor none"],
    [['--height', '150', '--sheets', '3'], "option '--sheets': the size is given by '--height'"],
    [['--sheets', '1.5'], "option '--sheets': '1.5' is not a whole number"],
    [['--flaps', '0'], "option '--flaps': '0' is not a number from 1 to 50, nor none"],
    [['--flap-angle', '61'], "option '--flap-angle': '61' is not a number from 10 to 60"],
    [['--flap-side', 'left'], "option '--flap-side': 'left' is not one or alternate or both"],
    [
      ['--ids', 'everywhere'],
      "option '--ids': 'everywhere' is not inside or flap or both or outside or none",
    ],
    [['--depth', '0'], "option '--depth': '0' is not a number from 1 to 100000, nor none"],
    [['--width', '9', '--depth', '9'], "option '--depth': the size is given by '--width'"],
    [['--up', 'w'], "option '--up': 'w' is not guess or x or y or z"],
    [
      ['--fill-holes', '101'],
      "option '--fill-holes': '101' is not a number from 0.1 to 100, nor all",
    ],
    [['--unit', 'ft'], "option '--unit': 'ft' is not guess or mm"],
    [['--split', '0'], "option '--split': '0' is not a whole number from 1"],
    [['--split', '3:'], "option '--split': '3:' is not a whole number from 1"],
    [['--split', '3:2:1'], "option '--split': '3:2:1' is not PART or PART:K"],
    [['--split'], "option '--split <part[:k]>' argument missing"],
    [['--merge', '3'], "option '--merge': '3' is not A,B"],
    [['--merge', '3;4'], "option '--merge': '3;4' is not a whole number from 1"],
    [['--name', 'head'], "option '--name': 'head' is not PART=TEXT"],
    [['--name', '1='], "option '--name': '1=' is not PART=TEXT"],
    [
      ['--name', 'one=head'],
      "option '--name': 'one=head' names no part: 'one' is not a whole number from 1",
    ],
    [['--name', '1=a', '--name', '1=b'], "option '--name': part 1 has a name already"],
    [['--assembly', 'yes'], "option '--assembly': 'yes' is not on or off"],
    [
      ['-o', 'out.png', '--paper', 'A2', '--dpi', '1200'],
      "'out.png': 1200 dots per inch are too many",
    ],
    [['--texture', 'yes'], "option '--texture': 'yes' is not on or off or auto"],
    [['--colour', 'face'], "option '--colour': 'face' is not part or none"],
    [['--flap-bleed', '1'], "option '--flap-bleed': '1' is not none or half or whole"],
    [['--dpi', '71'], "option '--dpi': '71' is not a whole number from 72 to 1200"],
    [['-o', 'out.txt'], "'out.txt': the ending '.txt' is none of .fold, .svg, .pdf"],
    [['-o', 'out'], "'out': the ending '' is none of"],
    [['second.obj'], 'too many arguments'],
  ])('refuses %j in one sentence', async (args, sentence) => {
    expect(await refusal(args)).toContain(sentence);
  });

  it('refuses outputs that cannot be written, before any work', async () => {
    await inFolder(async (folder) => {
      const missing = join(folder, 'nowhere', 'out.svg');
      expect(await refusal(['-o', missing])).toContain(
        `'${join(folder, 'nowhere')}' does not exist`,
      );
      writeFileSync(join(folder, 'file'), '');
      expect(await refusal(['--report', join(folder, 'file', 'r.json')])).toMatch(
        /not a directory/,
      );
      mkdirSync(join(folder, 'out.svg'));
      expect(await refusal(['-o', join(folder, 'out.svg')])).toContain('is a directory');
      const twice = ['-o', join(folder, 'a.svg'), '--report', join(folder, 'a.svg')];
      expect(await refusal(twice)).toContain('named twice');
      expect(readdirSync(folder).sort()).toEqual(['file', 'out.svg']);
    });
  });

  it('refuses models that are no files', async () => {
    await inFolder(async (folder) => {
      const empty = join(folder, 'empty.obj');
      writeFileSync(empty, '');
      const hidden = join(folder, 'hidden');
      mkdirSync(hidden);
      writeFileSync(join(hidden, '.model.obj'), 'v 0 0 0');
      const cases = [
        [hidden, 'there is no file in the folder'],
        [folder, 'the file is empty'],
        [empty, 'the file is empty'],
        [join(folder, 'none.obj'), 'there is no such file'],
        [join(empty, 'none.obj'), 'there is no such file'],
      ];
      for (const [model, sentence] of cases) {
        const { status, stdout, stderr } = await foldwright([model!, '--quiet']);
        expect([status, stdout, stderr]).toEqual([3, '', `${model}: ${sentence}\n`]);
      }
    });
  });
});
