/** The steps of the repair, as people switch them. */
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { readSettings, savedSettings } from '../../web/api/saved-state.js';
import { changedSettings, defaultSettings } from '../../web/api/written-options.js';
import { repairsOff } from '../../web/model/option-values.js';
import { echo, jobOptions } from '../../web/model/options.js';
import {
  repairCodes,
  repairSteps,
  switchableSteps,
  writtenRepair,
} from '../../web/model/repair-steps.js';
import { BadOption } from '../../web/words/bad-option.js';

const sources = join(import.meta.dirname, '../../cpp');

const usual = defaultSettings();

function refusal(repair: unknown): string {
  try {
    changedSettings(usual, { repair });
  } catch (error) {
    if (error instanceof BadOption) return error.message;
    throw error;
  }
  return '';
}

describe('the steps of the repair', () => {
  it('are those of the engine, in its order', () => {
    const header = readFileSync(join(sources, 'repair/repair_steps.h'), 'utf8');
    const rows = [...header.matchAll(/\{"([a-z-]+)", StepKind::k(\w+)\}/g)];
    const kinds = { Switch: 'switch', Request: 'request', Always: 'always' } as const;
    const ofEngine = rows.map(([, name, kind]) => [name, kinds[kind as keyof typeof kinds]]);
    expect(ofEngine).toEqual(Object.entries(repairSteps));
  });

  it('are told under codes that the engine has', () => {
    const codes = readFileSync(join(sources, 'mesh/message_codes.h'), 'utf8');
    for (const code of Object.values(repairCodes)) expect(codes).toContain(`"${code}"`);
  });

  it('can be switched where nothing depends on them', () => {
    expect(switchableSteps).toEqual([
      'weld',
      'duplicates',
      'two-sided',
      't-junctions',
      'cracks',
      'winding',
      'flatten',
    ]);
  });
});

describe('a list of switches', () => {
  it('names the steps that are off, in their own order', () => {
    expect(repairsOff('on')).toEqual([]);
    expect(repairsOff('cracks=off,weld=off')).toEqual(['weld', 'cracks']);
    expect(repairsOff('weld=off,weld=on')).toEqual([]);
    expect(repairsOff('weld=off,on,cracks=off')).toEqual(['cracks']);
  });

  it('is what is written of them', () => {
    for (const off of [[], ['weld'], ['weld', 'winding']] as const) {
      expect(repairsOff(writtenRepair(off))).toEqual(off);
    }
  });

  it('is refused with a sentence for steps that cannot be off', () => {
    expect(refusal('degenerate=off')).toBe(
      "option 'repair': 'degenerate=off' names 'degenerate', which cannot be switched off: a face without an area has no place in a net",
    );
    expect(refusal('polygons=off')).toContain('nets are made of triangles');
    expect(refusal('weld=off,non-manifold=off')).toContain('a fold joins two faces and no more');
    expect(refusal('holes=off')).toBe(
      "option 'repair': 'holes=off' names 'holes', which is done only where --fill-holes asks for it",
    );
    for (const [step, option] of [
      ['crossing', '--crossing'],
      ['inside', '--inside'],
    ]) {
      expect(refusal(`${step}=on`)).toContain(`only where ${option} asks for it`);
    }
  });

  it('is refused with the names of the steps where it is no list', () => {
    for (const text of ['weld', 'weld=maybe', 'weld=off=on', 'toString=off', '', 'off']) {
      expect(refusal(text)).toContain('is no list such as weld=off; there are weld, duplicates, ');
    }
  });
});

describe('the option of programs', () => {
  it('takes an object, and what the command line takes', () => {
    const repairOf = (repair: unknown): unknown => changedSettings(usual, { repair }).repair;
    expect(repairOf({ weld: 'off', cracks: false })).toEqual(['weld', 'cracks']);
    expect(repairOf({ 't-junctions': 'off', winding: 'on', flatten: true })).toEqual([
      't-junctions',
    ]);
    expect(repairOf({})).toEqual([]);
    expect(repairOf('weld=off')).toEqual(['weld']);
    expect(refusal({ degenerate: 'off' })).toContain("'degenerate=off' names 'degenerate'");
  });

  it('goes to the engine, the report and the project', () => {
    const settings = changedSettings(usual, { repair: { weld: 'off' } });
    expect(jobOptions(settings).repairOff).toEqual(['weld']);
    expect(echo(settings)['repair']).toBe('weld=off');
    expect(readSettings(savedSettings(settings))).toEqual({ settings, lost: [] });
  });

  it('does all steps for projects from before it', () => {
    const { repair, ...before } = savedSettings(usual);
    expect(repair).toBe('on');
    expect(readSettings(before)).toEqual({ settings: usual, lost: [] });
  });
});
