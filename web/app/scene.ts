/** What the state of a studio consists of, in words. */

/** What is being done. */
export type Work = 'idle' | 'running' | 'editing';

/** What fills the page: the pictures of a run need the room of a result. */
export type Scene = 'welcome' | 'empty' | 'exhibit' | 'check' | 'pictures' | 'result';

/** What can change. */
export type Topic = 'choice' | 'check' | 'work' | 'scene' | 'selection';
