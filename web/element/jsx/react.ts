/** Tells React's JSX (19 or later) of the elements: `import type {} from 'foldwright/jsx/react'`. */
import type { DetailedHTMLProps, HTMLAttributes } from 'react';
import type { JsxElements } from './attributes.js';

type Elements = {
  [Tag in keyof JsxElements]: JsxElements[Tag]['own'] &
    Omit<
      DetailedHTMLProps<HTMLAttributes<JsxElements[Tag]['element']>, JsxElements[Tag]['element']>,
      keyof JsxElements[Tag]['own']
    >;
};

declare module 'react' {
  // What is merged with the library's own must be spelled as that is.
  // eslint-disable-next-line @typescript-eslint/no-namespace
  namespace JSX {
    // eslint-disable-next-line @typescript-eslint/no-empty-object-type
    interface IntrinsicElements extends Elements {}
  }
}
