/** Finding and making elements. Text always goes in as text, never as markup. */

/** The element that `selector` names, on the page or in one of its elements; without it the page itself is broken. */
export function find<E extends Element>(
  selector: string,
  type: new () => E,
  within: ParentNode = document,
): E {
  const found = within.querySelector(selector);
  if (!(found instanceof type)) throw new Error(`The page has no ${type.name} at ${selector}`);
  return found;
}

/** A new element with properties and children. */
export function make<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  properties: Partial<HTMLElementTagNameMap[K]> = {},
  ...children: (Node | string)[]
): HTMLElementTagNameMap[K] {
  const element = Object.assign(document.createElement(tag), properties);
  element.append(...children);
  return element;
}

const editable = 'select, textarea, input:not([type=checkbox], [type=file], [type=range])';

/** Whether an event is about a field that holds what a person writes or picks: its keys and drops are its own. */
export function isForField({ target }: Event): boolean {
  return target instanceof Element && target.closest(editable) !== null;
}
