/**
 * Calls `action` when a button is pressed that can be used now. One that is not to be used keeps the keyboard's place
 * all the same.
 */
export function onPress(button: HTMLButtonElement, action: (event: MouseEvent) => void): void {
  button.addEventListener('click', (event) => {
    if (button.getAttribute('aria-disabled') !== 'true') action(event);
  });
}
