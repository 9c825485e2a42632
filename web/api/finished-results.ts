/** Makes the engine's results those that people get: under the model's own name, and with how it looks. */
import type { TimedEngineEvent, TimedEvent } from '../core/protocol.js';
import type { EngineResult, JobResult, Notice } from '../model/job.js';
import type { EngineLooks } from '../model/looks.js';
import type { ModelFiles } from '../model/model-files.js';
import { Companions, sourceOf } from '../read/companions.js';
import { fileLooks, type FileLooks } from '../read/file-looks.js';
import { joinLooks } from '../read/join-looks.js';
import type { ReadModel } from '../read/read-model.js';

/** Results of one model; what lies beside it is read once. */
export class FinishedResults {
  private readonly files: ModelFiles;
  private companions: Companions | null = null;
  private looks: FileLooks | null = null;

  /** @param model what a reader has made of the files; null where the engine reads them by itself */
  constructor(
    files: ModelFiles,
    private readonly model: ReadModel | null,
  ) {
    this.files = model ? [model.file, ...model.companions] : files;
  }

  of<Result extends EngineResult>(
    result: Result,
  ): Omit<Result, 'looks'> & Pick<JobResult, 'looks'> {
    const { looks: engine, ...rest } = result;
    const found = engine && this.looksOf(result.file, engine);
    const looks = engine && found && joinLooks(engine, found);
    const notices = [
      ...(this.model?.notices ?? []),
      ...result.notices.flatMap((notice) => this.stillTrue(notice)),
      ...(found?.notices ?? []),
    ];
    return { ...rest, file: this.model?.name ?? result.file, notices, ...(looks && { looks }) };
  }

  /** Whether an event tells what only the result can know: which files beside the model were used. */
  isPremature(event: TimedEngineEvent): boolean {
    return event.type === 'notice' && event.code === 'files-ignored';
  }

  ofEvent(event: TimedEngineEvent): TimedEvent {
    if (event.type === 'model') return { ...event, file: this.model?.name ?? event.file };
    if (event.type === 'done' || event.type === 'draft')
      return { ...event, result: this.of(event.result) };
    if (event.type !== 'cancelled') return event;
    const { best, ...rest } = event;
    return best ? { ...rest, best: this.of(best) } : rest;
  }

  /** @param name of the file that the engine has read */
  private looksOf(name: string, engine: EngineLooks): FileLooks {
    if (this.model?.looks) return { ...this.model.looks, isForAll: false, notices: [] };
    const model = this.files.find((file) => file.name === name)!;
    this.companions ??= new Companions(sourceOf(this.files), name);
    this.looks ??= fileLooks(model, engine, this.companions);
    return this.looks;
  }

  /** The engine does not know which of the files beside the model are used here. */
  private stillTrue(notice: Notice): Notice[] {
    if (notice.code !== 'files-ignored') return [notice];
    const all = notice.params['files'] as readonly string[];
    const files = all.filter((file) => !this.companions?.isUsed(file));
    return files.length > 0 ? [{ ...notice, params: { files } }] : [];
  }
}
