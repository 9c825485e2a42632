// Languages that are written without blanks have a full stop of their own.
const wideLetter = /[\p{Script=Han}\p{Script=Hiragana}\p{Script=Katakana}ー）」]$/u;

/** Messages are phrases, which may be part of a line; on their own they become sentences. */
export function sentence(phrase: string): string {
  const text = phrase.charAt(0).toUpperCase() + phrase.slice(1);
  if (/[.!?。！？]$/.test(text)) return text;
  return wideLetter.test(text) ? `${text}。` : `${text}.`;
}
