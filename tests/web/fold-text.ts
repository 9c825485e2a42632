import type { Session } from '../../web/api/session.js';

/** The FOLD file of a session's present result. */
export async function foldText(session: Session): Promise<string> {
  const [file] = await session.export('fold');
  return new TextDecoder().decode(file!.bytes);
}
