import { isForField } from './dom.js';
import type { PickedFile } from './model-file.js';
import type { StudioPlace } from './place.js';

/** What text that is pasted would be called as a file: which format it has its contents tell. */
const pastedName = 'pasted.obj';

/** Takes files that are pasted, as a file manager copies them, and models that are pasted as text. */
export function listenForPaste(
  { ground, life }: StudioPlace,
  onFiles: (files: readonly PickedFile[]) => void,
): void {
  const paste = (event: Event): void => {
    if (!(event instanceof ClipboardEvent) || !event.clipboardData || isForField(event)) return;
    const { files } = event.clipboardData;
    const text = event.clipboardData.getData('text/plain');
    const picked = [...files].map((file) => ({ path: file.name, file }));
    if (picked.length === 0 && looksLikeModel(text)) {
      picked.push({ path: pastedName, file: new File([text], pastedName) });
    }
    if (picked.length === 0) return;
    event.preventDefault();
    onFiles(picked);
  };
  ground.addEventListener('paste', paste, { signal: life });
}

/** Whether a text may be a model: several lines, with numbers in them. Who pastes a word or an address means none. */
function looksLikeModel(text: string): boolean {
  return text.split('\n', 4).length === 4 && /\d\s+-?\d/.test(text);
}
