import type { StudioPlace } from './place.js';
import type { Store } from './store.js';

/** A tool that shows what is chosen on the sheets. */
interface SheetTool {
  /** Chooses nothing any more. */
  close(): void;
  /** Shows what is chosen as it is now. */
  show(): void;
}

/** Lets a tool choose nothing any more at Escape and when a run begins, and show what is chosen when work begins or ends. */
export function followWork({ ground, life }: StudioPlace, store: Store, tool: SheetTool): void {
  const leave = (event: Event): void => {
    if (event instanceof KeyboardEvent && event.key === 'Escape') tool.close();
  };
  ground.addEventListener('keydown', leave, { signal: life });
  store.on('work', () => {
    if (store.work === 'running') tool.close();
    else tool.show();
  });
}
