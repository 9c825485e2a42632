/** Finding and making elements. Text always goes in as text, never as markup. */

/** The element that `selector` names within another one; without it the markup itself is broken. */
export function find<E extends Element>(
  within: ParentNode,
  selector: string,
  type: new () => E,
): E {
  const found = within.querySelector(selector);
  if (!(found instanceof type)) throw new Error(`The markup has no ${type.name} at ${selector}`);
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
export function isForField(event: Event): boolean {
  // Outside of a shadow tree, `target` is no more than the element that has it.
  const [target] = event.composedPath();
  return target instanceof Element && target.closest(editable) !== null;
}
