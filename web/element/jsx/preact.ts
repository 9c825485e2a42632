/** Tells Preact's JSX of the elements: `import type {} from 'foldwright/jsx/preact'`. */
import type { ClassAttributes, HTMLAttributes } from 'preact';
import type { JsxElements } from './attributes.js';

type Elements = {
  [Tag in keyof JsxElements]: JsxElements[Tag]['own'] &
    Omit<
      HTMLAttributes<JsxElements[Tag]['element']> & ClassAttributes<JsxElements[Tag]['element']>,
      keyof JsxElements[Tag]['own']
    >;
};

declare module 'preact' {
  // What is merged with the library's own must be spelled as that is.
  // eslint-disable-next-line @typescript-eslint/no-namespace
  namespace JSX {
    // eslint-disable-next-line @typescript-eslint/no-empty-object-type
    interface IntrinsicElements extends Elements {}
  }
}
