/** Who hears of changes, by what has changed. */
export class Topics<Topic extends string> {
  private readonly listeners = new Map<Topic, (() => void)[]>();

  /** @param life after which nobody is told anything */
  constructor(private readonly life: AbortSignal) {}

  /** Calls `listener` after every change. */
  on(topic: Topic, listener: () => void): void {
    this.listeners.set(topic, [...(this.listeners.get(topic) ?? []), listener]);
  }

  tell(topics: readonly Topic[]): void {
    if (this.life.aborted) return;
    for (const topic of topics) for (const listener of this.listeners.get(topic) ?? []) listener();
  }
}
