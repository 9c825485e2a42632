import { readFileSync } from 'node:fs';
import { Ajv } from 'ajv';
import { unzipSync } from 'fflate';

const path = new URL('../../web/export/project.schema.json', import.meta.url);
const ajv = new Ajv({ allErrors: true }).addSchema(
  JSON.parse(readFileSync(path, 'utf8')) as object,
);

/** What each of a project's documents is called in the schema. */
const definitions = {
  'project.json': 'foldwright-project',
  'results.json': 'foldwright-project#/definitions/results',
} as const;

/** The documents in the bytes of a project. */
export function documentsOf(bytes: Uint8Array): Record<keyof typeof definitions, unknown> {
  const entries = unzipSync(bytes);
  const json = (name: string): unknown => JSON.parse(new TextDecoder().decode(entries[name]));
  return { 'project.json': json('project.json'), 'results.json': json('results.json') };
}

/** What of a project the schema does not allow; none if it is valid. */
export function projectErrors(bytes: Uint8Array): string[] {
  return Object.entries(documentsOf(bytes)).flatMap(([name, value]) => {
    const validate = ajv.getSchema(definitions[name as keyof typeof definitions])!;
    if (validate(value)) return [];
    return validate.errors!.map(({ instancePath, message }) => `${name}${instancePath} ${message}`);
  });
}
