import { readFileSync } from 'node:fs';
import { Ajv } from 'ajv';

const schema = new URL('../../web/export/report.schema.json', import.meta.url);
const validate = new Ajv({ allErrors: true }).compile(
  JSON.parse(readFileSync(schema, 'utf8')) as object,
);

/** What of a report the schema does not allow; none if it is valid. */
export function schemaErrors(report: unknown): string[] {
  if (validate(report)) return [];
  return validate.errors!.map(({ instancePath, message }) => `${instancePath} ${message}`);
}
