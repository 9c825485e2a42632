import { UnusableChoice } from '../../web/app/model-file.js';
import { english } from '../../web/words/en/index.js';

/** What is said of a choice that gives no model. */
export async function faultOf(choice: Promise<unknown>): Promise<string> {
  const error: unknown = await choice.then(
    () => null,
    (reason: unknown) => reason,
  );
  if (error instanceof UnusableChoice) return error.tell(english);
  throw new Error('the choice is not refused', { cause: error });
}
