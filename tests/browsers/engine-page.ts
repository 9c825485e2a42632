/** What the three engines have in common, as far as the tests need it. */
export interface EnginePage {
  goto(address: string): Promise<void>;
  reload(): Promise<void>;
  /** Runs a function in the page; what goes in and what comes out is plain data. */
  evaluate<Result, Argument = undefined>(
    body: (argument: Argument) => Result | Promise<Result>,
    argument?: Argument,
  ): Promise<Result>;
  /** Moves the mouse to a place of the window and clicks, in CSS pixels. */
  click(x: number, y: number): Promise<void>;
  /** Presses keys one after the other: letters, or those that have a name in `keys`. */
  press(...keys: string[]): Promise<void>;
  resize(width: number, height: number): Promise<void>;
  /** A PNG file of what the window shows. */
  screenshot(): Promise<Uint8Array>;
  /** Ends the browser. */
  close(): Promise<void>;
}

/** A browser with a new profile. */
export interface Engine {
  name: string;
  /** @param display of a virtual screen */
  open(display: string): Promise<EnginePage>;
}
