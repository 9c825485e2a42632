/** What the address of the page asks for: `?model=models/whale.obj&parts=6&height=150`. */
import { rows } from '../model/options.js';

/** Options that the element has attributes for. */
const own = ['parts', 'seed', 'paper', 'faces', 'workers'] as const;

/**
 * Attributes of the studio that give what an address asks for. Names that are no options are left to others: addresses
 * get such on their way through mails and other sites.
 */
export function requestedAttributes(search: string): Map<string, string> {
  const asked = new URLSearchParams(search);
  const attributes = new Map<string, string>();
  const model = asked.get('model');
  if (model) attributes.set('src', model);
  for (const name of own) {
    const value = asked.get(name);
    if (value !== null) attributes.set(name, value);
  }
  const others = [...asked].filter(
    ([name]) => name in rows && !(own as readonly string[]).includes(name),
  );
  if (others.length > 0) attributes.set('options', String(new URLSearchParams(others)));
  return attributes;
}
