// Where this machine gets its Debian packages from, in both notations of APT's sources.
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';

/** Name and version name of the running system, such as {id: 'debian', codename: 'bookworm'}. */
export function operatingSystem(file = '/etc/os-release') {
  const text = existsSync(file) ? readFileSync(file, 'utf8') : '';
  const field = (name) => text.match(new RegExp(`^${name}="?([^"\n]*)"?$`, 'm'))?.[1] ?? '';
  return { id: field('ID'), codename: field('VERSION_CODENAME') };
}

/** Entries of a `.sources` file: stanzas of fields, continued lines indented. */
export function parseDeb822(text) {
  return text.split(/\n\s*\n/).flatMap((stanza) => {
    const lines = stanza.split('\n').filter((line) => !line.startsWith('#'));
    const fields = {};
    let name = '';
    for (const line of lines) {
      const start = line.match(/^([A-Za-z-]+):\s*(.*)$/);
      if (start) fields[(name = start[1].toLowerCase())] = start[2];
      else if (name) fields[name] += ` ${line.trim()}`;
    }
    if (!fields.uris || /^(no|false|0)$/i.test(fields.enabled ?? '')) return [];
    const words = (field) => (fields[field] ?? '').split(/\s+/).filter(Boolean);
    return words('uris').map((uri) => ({ types: words('types'), uri, suites: words('suites') }));
  });
}

/** Entries of a classic list: `deb [options] URI SUITE COMPONENT...`. */
export function parseList(text) {
  return text.split('\n').flatMap((line) => {
    const match = line.match(/^\s*(deb|deb-src)\s+(?:\[[^\]]*\]\s+)?(\S+)\s+(\S+)/);
    return match ? [{ types: [match[1]], uri: match[2], suites: [match[3]] }] : [];
  });
}

/** The mirror that serves the running system's own suite. */
export function debianMirror(codename, etc = '/etc/apt') {
  const parts = join(etc, 'sources.list.d');
  const names = existsSync(parts) ? readdirSync(parts).sort() : [];
  const files = [join(etc, 'sources.list'), ...names.map((name) => join(parts, name))];
  const entries = files.filter(existsSync).flatMap((file) => {
    if (file.endsWith('.sources')) return parseDeb822(readFileSync(file, 'utf8'));
    return file.endsWith('.list') ? parseList(readFileSync(file, 'utf8')) : [];
  });
  return entries.find((entry) => entry.types.includes('deb') && entry.suites.includes(codename))
    ?.uri;
}
