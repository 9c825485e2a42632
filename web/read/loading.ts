import { unreadable } from './unreadable.js';

/** Something that is loaded when it is first needed. @throws Unreadable where that fails, as without a network */
export async function loaded<Value>(load: () => Promise<Value>): Promise<Value> {
  try {
    return await load();
  } catch {
    throw unreadable('reader-not-loaded', {});
  }
}
