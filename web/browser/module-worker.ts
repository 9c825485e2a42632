/** A script that imports another one, for each that was asked for; few, and so none is ever given back. */
const relays = new Map<string, string>();

/** The address of a script of this page's own that imports the one at `address`. */
function relayTo(address: string): string {
  const known = relays.get(address);
  if (known !== undefined) return known;
  const script = `import ${JSON.stringify(address)};`;
  const relay = URL.createObjectURL(new Blob([script], { type: 'text/javascript' }));
  relays.set(address, relay);
  return relay;
}

/**
 * Starts a worker from a module at an absolute address. Browsers start workers only from the page's own
 * origin, but let modules import from any that allows it (CORS): so scripts that lie elsewhere are imported
 * by one that does not.
 *
 * @param name what the script finds as its own `name`
 */
export function startModuleWorker(address: string, name = ''): Worker {
  const isOwn = new URL(address, location.href).origin === location.origin;
  return new Worker(isOwn ? address : relayTo(address), { type: 'module', name });
}
