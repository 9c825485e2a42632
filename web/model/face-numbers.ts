/** How many triangles a paper model has; the engine's notice `large-model` goes by the same numbers. */

/** What people build has 200 to 1500. Above this number fewer are proposed. */
export const usualFaces = 2000;

/** As many as are proposed for a larger model. */
export const proposedFaces = 1500;

/** Numbers that are worth a look, from coarse to fine. */
export const faceLevels = [200, 500, 1000, proposedFaces] as const;

/** Nets of more than these take hours, so the engine refuses them unless a number of faces is given. */
export const mostFaces = 100_000;
