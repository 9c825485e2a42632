import { isForField } from './dom.js';
import type { StudioPlace } from './place.js';

/** Ctrl+Z takes back and Ctrl+Shift+Z makes again, with Cmd on a Mac; in a field they are the field's own. */
export function listenForUndo(
  { ground, life }: StudioPlace,
  { undo, redo }: { undo: () => void; redo: () => void },
): void {
  const press = (event: Event): void => {
    if (!(event instanceof KeyboardEvent) || event.altKey || isForField(event)) return;
    if (!(event.ctrlKey || event.metaKey) || event.key.toLowerCase() !== 'z') return;
    event.preventDefault();
    if (event.shiftKey) redo();
    else undo();
  };
  ground.addEventListener('keydown', press, { signal: life });
}
