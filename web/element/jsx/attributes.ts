/** Attributes and listeners of the elements as they are written in JSX; `react.ts`, `preact.ts` and `solid.ts` tell each library. */
import type { FoldwrightStudio, StudioEventMap } from '../studio-element.js';
import type { StudioSwitchAttribute, StudioTextAttribute } from '../studio-attributes.js';
import type { SwitchAttribute, TextAttribute } from '../viewer/viewer-attributes.js';
import type { FoldwrightViewer, ViewerEventMap } from '../viewer/viewer-element.js';

type Written<Texts extends string, Switches extends string> = {
  [Name in Texts]?: string | number | undefined;
} & { [Name in Switches]?: boolean | undefined };

export type ViewerAttributes = Written<TextAttribute | 'fold', SwitchAttribute>;
export type StudioAttributes = Written<StudioTextAttribute, StudioSwitchAttribute>;

/** Listeners by the names of their events, behind what a library writes before them. */
type Listeners<Events, Prefix extends string> = {
  [Name in keyof Events & string as `${Prefix}${Name}`]?:
    ((event: Events[Name]) => void) | undefined;
};

/** An element of a page, and what it takes beside what all elements do. */
export interface JsxElements<Prefix extends string = 'on'> {
  'foldwright-viewer': {
    element: FoldwrightViewer;
    own: ViewerAttributes & Listeners<ViewerEventMap, Prefix>;
  };
  'foldwright-studio': {
    element: FoldwrightStudio;
    own: StudioAttributes & Listeners<StudioEventMap, Prefix>;
  };
}
