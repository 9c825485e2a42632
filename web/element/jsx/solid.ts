/** Tells Solid's JSX of the elements: `import type {} from 'foldwright/jsx/solid'`. */
import type { JSX } from 'solid-js';
import type { JsxElements } from './attributes.js';

type Elements = {
  [Tag in keyof JsxElements<'on:'>]: JsxElements<'on:'>[Tag]['own'] &
    Omit<
      JSX.HTMLAttributes<JsxElements<'on:'>[Tag]['element']>,
      keyof JsxElements<'on:'>[Tag]['own']
    >;
};

declare module 'solid-js' {
  // What is merged with the library's own must be spelled as that is.
  // eslint-disable-next-line @typescript-eslint/no-namespace
  namespace JSX {
    // eslint-disable-next-line @typescript-eslint/no-empty-object-type
    interface IntrinsicElements extends Elements {}
  }
}
