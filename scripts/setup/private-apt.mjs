// An APT of our own: other suites and sources than the system's, without a change to the system and without root.
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { debianMirror, operatingSystem } from './apt-sources.mjs';
import { toolchain } from './paths.mjs';
import { run, SetupError } from './shell.mjs';

const keyring = '/usr/share/keyrings/debian-archive-keyring.gpg';

/**
 * @param type 'deb' or 'deb-src'
 * @param suite such as 'trixie'
 * @returns a function that runs `apt-get` on that suite alone, its lists already up to date
 */
export function privateApt(type, suite) {
  const mirror = debianMirror(operatingSystem().codename);
  if (!mirror) throw new SetupError('no Debian mirror found in the sources of APT');
  const home = join(toolchain, 'apt', `${type}-${suite}`);
  for (const folder of ['lists/partial', 'cache/archives/partial']) {
    mkdirSync(join(home, folder), { recursive: true });
  }
  writeFileSync(
    join(home, 'sources.list'),
    `${type} [signed-by=${keyring}] ${mirror} ${suite} main\n`,
  );
  writeFileSync(join(home, 'status'), '');
  const options = [
    `Dir::Etc::sourcelist=${join(home, 'sources.list')}`,
    'Dir::Etc::sourceparts=-',
    `Dir::State::lists=${join(home, 'lists')}`,
    `Dir::State::status=${join(home, 'status')}`,
    `Dir::Cache=${join(home, 'cache')}`,
    'Acquire::Languages=none',
    'APT::Sandbox::User=root', // the private folders need not be open to APT's own user
    'DPkg::Lock::Timeout=500',
  ].flatMap((option) => ['-o', option]);
  const apt = (args, cwd) => run('apt-get', ['-q', ...options, ...args], { cwd });
  apt(['update']);
  return apt;
}
