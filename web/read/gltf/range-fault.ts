/** A number in a file that leads nowhere, or to more than can be meant. */
export class RangeFault extends Error {}
