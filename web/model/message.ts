/** A value that a sentence needs. */
export type MessageValue = number | string | readonly number[] | readonly string[];
export type MessageParams = Readonly<Record<string, MessageValue>>;

/** Something that people are told, without its words, which `web/words` has. */
export interface Message {
  /** A stable word for programs. */
  code: string;
  params: MessageParams;
}
