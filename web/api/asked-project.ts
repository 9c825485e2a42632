import { version } from '../../package.json';
import type { ModelFiles } from '../model/model-files.js';
import type { Settings } from '../model/options.js';
import type { Project } from '../project/project.js';
import { savedSettings } from './saved-state.js';

/** A project without a result: what was asked for. Whoever opens it unfolds the model. */
export function askedProject(
  { name, files }: { name: string; files: ModelFiles },
  settings: Settings,
): Project {
  const options = savedSettings(settings);
  return { app: version, name, files, options, steps: [], cursor: 0, states: [null] };
}
