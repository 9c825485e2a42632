import { readFileSync } from 'node:fs';
import { Ajv } from 'ajv';

/** What of a value a schema of `web/export` does not allow; none if it is valid. */
function errorsBy(name: string): (value: unknown) => string[] {
  const schema = new URL(`../../web/export/${name}`, import.meta.url);
  const validate = new Ajv({ allErrors: true }).compile(
    JSON.parse(readFileSync(schema, 'utf8')) as object,
  );
  return (value) => {
    if (validate(value)) return [];
    return validate.errors!.map(({ instancePath, message }) => `${instancePath} ${message}`);
  };
}

/** What of a report the schema does not allow; none if it is valid. */
export const schemaErrors = errorsBy('report.schema.json');

/** The same of a line that a batch tells. */
export const batchSchemaErrors = errorsBy('batch.schema.json');
