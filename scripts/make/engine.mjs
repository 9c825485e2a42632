// The C++ builds. Ninja knows what changed; only the configuration has to be watched here.
import { join } from 'node:path';
import { root, toolchain } from '../setup/paths.mjs';
import { run } from '../setup/shell.mjs';
import { contentFingerprint, once } from '../setup/stamp.mjs';

/** @param preset of CMakePresets.json  @param targets all when empty */
export function buildEngine(preset, targets = []) {
  const folder = join(root, 'build', preset);
  // CMake re-reads its own lists, but neither the presets nor the toolchain file's place.
  const configuration = [join(root, 'CMakePresets.json'), join(toolchain, 'emscripten.cmake')];
  once(
    `configure-${preset}`,
    contentFingerprint(configuration),
    () => run('cmake', ['--fresh', '--preset', preset], { cwd: root }),
    [join(folder, 'build.ninja')],
  );
  const choice = targets.flatMap((target) => ['--target', target]);
  run('cmake', ['--build', '--preset', preset, ...choice], { cwd: root });
}
