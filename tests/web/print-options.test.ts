import { describe, expect, it } from 'vitest';
import { lookOf } from '../../web/export/line-style.js';
import { parseCommandLine } from '../../web/cli/command-line.js';
import { printOptions } from '../../web/model/options.js';
import { defaultPrint } from '../../web/model/print-options.js';
import { changedSettings, defaultSettings, lookOptions } from '../../web/api/written-options.js';
import { english } from '../../web/words/en/index.js';

const optionsOf = (...args: string[]) =>
  printOptions(parseCommandLine(['a.obj', ...args], english).settings);

describe('print options', () => {
  it('are the defaults when nothing is asked for', () => {
    expect(optionsOf()).toEqual({
      ...defaultPrint,
      lines: { cut: {}, mountain: {}, valley: {} },
    });
  });

  it('keep what the style says where nothing else is asked for', () => {
    const { lines, flaps } = lookOf(
      optionsOf('--style', 'blender', '--cut-width', '0.4', '--mountain-dash', '2,1'),
    );
    expect(lines.cut).toEqual({ width: 0.4, colour: '#000000', dash: [] });
    expect(lines.mountain).toEqual({ width: 0.2, colour: '#000000', dash: [2, 1] });
    expect(lines.valley.dash).toHaveLength(4);
    expect(flaps).toBe('#e6e6e6');
  });

  it('take lines for a machine in place of a style, and what differs from them', () => {
    const { lines, flaps } = lookOf(
      optionsOf(
        ...['--machine', 'generic', '--style', 'blender', '--flap-colour', '#eeeeee'],
        ...['--mountain-dash', '3,1', '--cut-width', '0.2'],
      ),
    );
    expect(lines.cut).toEqual({ width: 0.2, colour: '#ff0000', dash: [] });
    expect(lines.mountain).toEqual({ width: 0.1, colour: '#0000ff', dash: [3, 1] });
    expect(flaps).toBe('none');
  });

  it('take colours, solid folds and what rulers measure', () => {
    const options = optionsOf(
      ...['--valley-colour', '#C02020', '--valley-dash', 'solid', '--flap-colour', '#eeeeee'],
      ...['--measured', '49.6,50.25', '--fold-angles', 'on', '--legend', 'off'],
    );
    expect(options.lines.valley).toEqual({ colour: '#c02020', dash: [] });
    expect(options).toMatchObject({
      flaps: '#eeeeee',
      measured: [49.6, 50.25],
      foldAngles: true,
      legend: false,
    });
  });

  it('are true and false in programs', () => {
    const switches = { assembly: true, legend: false, foldTicks: true, duplex: true };
    const settings = changedSettings(defaultSettings(), switches);
    expect(printOptions(settings)).toMatchObject(switches);
    expect(() => changedSettings(defaultSettings(), { parts: true })).toThrow("'true' is not");
  });

  it.each([
    [],
    ['--style', 'pepakura', '--cut-width', '0.4', '--mountain-dash', '2,1,0.5,1'],
    ['--valley-dash', 'solid', '--valley-colour', '#c02020', '--flap-colour', 'none'],
    ['--machine', 'silhouette', '--dpi', '600', '--mountain-dash', '3,1'],
    ['--flap-colour', '#eeeeee', '--flat-fold', '12', '--fold-angles', 'on', '--legend', 'off'],
    ['--assembly', 'on'],
    ['--fold-ticks', 'on', '--duplex', 'on'],
    ['--texture', 'off', '--colour', 'part', '--flap-bleed', 'whole'],
    ['--texture', 'on', '--flap-bleed', 'none'],
    ['--shading', 'on', '--colour', 'part'],
  ])('can be written down and read again', (...args) => {
    const looks = optionsOf(...args);
    const again = changedSettings(defaultSettings(), lookOptions(looks));
    expect(printOptions(again)).toEqual(looks);
  });

  it.each([
    ['--style', 'origami', 'is not foldwright or pepakura or blender'],
    ['--cut-width', '5', 'is not a number from 0.01 to 2, nor style'],
    ['--mountain-dash', '1,2,3', 'is neither solid nor lengths of dashes and gaps in turn'],
    ['--cut-colour', 'red', 'is not #RRGGBB, nor style'],
    ['--measured', '50', 'is not two values with a comma between them, nor off'],
    ['--measured', '50,60', 'is not a number from 45 to 55, nor off'],
    ['--fold-angles', 'yes', 'is not on or off'],
    ['--assembly', 'cover', 'is not on or off'],
    ['--duplex', 'long', 'is not on or off'],
    ['--fold-ticks', '3', 'is not on or off'],
    ['--texture', 'maybe', 'is not on or off or auto'],
    ['--colour', 'red', 'is not part or none'],
    ['--flap-bleed', '0.5', 'is not none or half or whole'],
    ['--machine', 'laser', 'is not none or silhouette or cricut or generic'],
    ['--dpi', '1201', 'is not a whole number from 72 to 1200'],
  ])('refuse %s %s', (name, value, sentence) => {
    expect(() => optionsOf(name, value)).toThrow(`option '${name}': '${value}' ${sentence}`);
  });
});
