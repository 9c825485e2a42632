import { find } from './dom.js';

/** The switch for hatches, which tell parts apart where colours do not: in grey and on prints. */
export class HatchSwitch {
  constructor(onChange: (hatched: boolean) => void) {
    const box = find('#hatch', HTMLInputElement);
    const tell = (): void => {
      // Sheets carry both fills; which one shows is a matter of style.
      document.documentElement.toggleAttribute('data-hatched', box.checked);
      onChange(box.checked);
    };
    box.addEventListener('change', tell);
    // A reloaded page may come back with the box ticked.
    tell();
  }
}
