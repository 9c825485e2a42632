import type { EngineLooks, LookedFiles, LookedSurface, Looks } from '../model/looks.js';

/** The number of the first material for each face. */
function allOfFirst(surface: LookedSurface): LookedSurface {
  const { places } = surface;
  return places ? { ...surface, materials: new Int32Array(places.length / 6) } : surface;
}

/** Whether it is all as white as paper. */
function isPlain({ surface, materials }: Looks): boolean {
  const isWhite = materials.every(
    ({ colour, picture }) => picture === null && colour.every((part) => part === 255),
  );
  return surface.colours === null && isWhite;
}

/** What the engine knows of a model's looks together with what its files hold; undefined where that is nothing. */
export function joinLooks(
  { surface }: EngineLooks,
  { isForAll = false, materials, pictures }: LookedFiles & { isForAll?: boolean },
): Looks | undefined {
  const looks = { surface: isForAll ? allOfFirst(surface) : surface, materials, pictures };
  return isPlain(looks) ? undefined : looks;
}
