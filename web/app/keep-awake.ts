/** Keeps the screen on while that is wanted, where the browser can. */
export class KeepAwake {
  private isWanted = false;
  private lock: WakeLockSentinel | null = null;

  /** @param page a browser takes the lock away while it is hidden */
  constructor(
    life: AbortSignal,
    private readonly page: Document,
  ) {
    const follow = (): void => void this.follow();
    page.addEventListener('visibilitychange', follow, { signal: life });
    life.addEventListener('abort', () => (this.wanted = false));
  }

  set wanted(wanted: boolean) {
    if (wanted === this.isWanted) return;
    this.isWanted = wanted;
    void this.follow();
  }

  private async follow(): Promise<void> {
    const isHeld = this.lock !== null && !this.lock.released;
    if (!this.isWanted) {
      const { lock } = this;
      this.lock = null;
      await lock?.release();
    } else if (!isHeld && this.page.visibilityState === 'visible' && 'wakeLock' in navigator) {
      // A battery that is nearly empty is a reason to refuse.
      this.lock = await navigator.wakeLock.request('screen').catch(() => null);
      // It may not be wanted any more.
      if (!this.isWanted) await this.follow();
    }
  }
}
