// Small pictures of what each option does: the same model with several values of it.
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { cropped, windowOf } from './crop.mjs';
import { effects, scenes } from './effects.mjs';
import { optionTable } from './option-table.mjs';

const camelCase = (name) => name.replace(/-(.)/g, (_, letter) => letter.toUpperCase());

/** The options of one group among those of a picture, whose names are in camel case. */
function ofGroup(options, rows, groups) {
  const names = rows
    .filter(({ group }) => groups.includes(group))
    .map(({ name }) => camelCase(name));
  return Object.fromEntries(
    names.flatMap((name) => (name in options ? [[name, options[name]]] : [])),
  );
}

/** Lays a finished run out with options of paper, and takes it back after `work`. */
async function withPaper(session, options, work) {
  const applied = await session.apply({ kind: 'paper', options });
  if (!applied.ok) throw new Error(`${JSON.stringify(options)}: ${applied.text}`);
  try {
    return await work();
  } finally {
    session.undo();
  }
}

/** The first sheet as SVG, or the cover before it, and the result that it shows. */
async function drawn(runs, model, options, rows) {
  const session = await runs.session(model, { seed: 1, ...ofGroup(options, rows, ['nets']) });
  return withPaper(session, ofGroup(options, rows, ['paper']), async () => {
    const files = await session.export('svg', ofGroup(options, rows, ['lines']));
    const file = files.find(({ name }) => name.includes('-building-')) ?? files[0];
    return { svg: Buffer.from(file.bytes).toString(), result: await session.result() };
  });
}

/** What a value is called below its picture. */
function labelOf({ name, fallback }, value) {
  return `--${name} ${value}${String(value) === fallback ? ', as without it' : ''}`;
}

async function figuresOf(row, runs, rows, folder) {
  const effect = effects[row.name];
  if (typeof effect === 'string') return [];
  const { scene, values, shown, also } = effect;
  const { model, options } = scenes[scene];
  const figures = [];
  for (const [i, value] of values.entries()) {
    const own = { ...options, ...also, [camelCase(row.name)]: value };
    const { svg, result } = await drawn(runs, model, own, rows);
    const file = `option-${row.name}-${i}.svg`;
    const [, , width, height] = windowOf(result, shown);
    writeFileSync(join(folder, file), cropped(svg, windowOf(result, shown)));
    figures.push({ file, label: labelOf(row, value), width, height });
  }
  return figures;
}

/** Fails for options that have neither a picture nor a reason for having none. */
function checkEffects(rows) {
  const names = rows.map(({ name }) => name);
  const missing = names.filter((name) => !(name in effects));
  const gone = Object.keys(effects).filter((name) => !names.includes(name));
  if (missing.length + gone.length > 0)
    throw new Error(`effects.mjs lacks ${missing.join(', ')}; no option is ${gone.join(', ')}`);
}

/** Draws all pictures into a folder. @returns the rows of the option table with their figures, or the reason why none */
export async function optionPictures(runs, folder) {
  const rows = await optionTable();
  checkEffects(rows);
  const drawnRows = [];
  for (const row of rows) {
    const effect = effects[row.name];
    const figures = await figuresOf(row, runs, rows, folder);
    drawnRows.push({ ...row, figures, ...(typeof effect === 'string' && { reason: effect }) });
  }
  return drawnRows;
}
