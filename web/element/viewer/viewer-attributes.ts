/** Attributes of a viewer that are its properties, too. */

/** Attributes that are texts, and the properties that reflect them. */
const texts = {
  src: 'src',
  alt: 'alt',
  poster: 'poster',
  loading: 'loading',
  reveal: 'reveal',
  view: 'view',
  parts: 'parts',
  seed: 'seed',
  paper: 'paper',
  solver: 'solver',
  flaps: 'flaps',
  'target-size': 'targetSize',
  theme: 'theme',
  'download-formats': 'downloadFormats',
} as const;

/** Attributes that are there or not. */
const switches = { controls: 'controls', readonly: 'readOnly' } as const;

export type TextAttribute = keyof typeof texts;
export type SwitchAttribute = keyof typeof switches;

/** Names of all of them. */
export const reflected: readonly string[] = [...Object.keys(texts), ...Object.keys(switches)];

/** Gives the class of an element the properties that reflect them. */
export function reflectAttributes(prototype: object): void {
  for (const [attribute, property] of Object.entries(texts)) {
    Object.defineProperty(prototype, property, {
      configurable: true,
      enumerable: true,
      get(this: HTMLElement) {
        return this.getAttribute(attribute) ?? '';
      },
      set(this: HTMLElement, value: string) {
        this.setAttribute(attribute, value);
      },
    });
  }

  for (const [attribute, property] of Object.entries(switches)) {
    Object.defineProperty(prototype, property, {
      configurable: true,
      enumerable: true,
      get(this: HTMLElement) {
        return this.hasAttribute(attribute);
      },
      set(this: HTMLElement, value: boolean) {
        this.toggleAttribute(attribute, value);
      },
    });
  }
}
