/** The package as the site has it, and the sample models beside it. */
import type * as Package from '../../web/api/browser.js';

const studio = new URL('../studio/', import.meta.url);

/** Loaded when somebody presses a button, not with the page. */
export function loadPackage(): Promise<typeof Package> {
  return import(new URL('foldwright.js', studio).href) as Promise<typeof Package>;
}

/** Samples of the demonstrations, with the names that people read. */
export const samples = {
  'whale.obj': 'Whale',
  'rabbit.obj': 'Rabbit',
  'cat.obj': 'Cat',
  'fish.obj': 'Fish',
  'duck.obj': 'Duck',
  'house.obj': 'House',
} as const;

export async function loadSample(name: string): Promise<Package.ModelFile> {
  const response = await fetch(new URL(`samples/${name}`, studio));
  if (!response.ok) throw new Error(`${name}: the server answers with ${response.status}`);
  return { name, bytes: new Uint8Array(await response.arrayBuffer()) };
}
