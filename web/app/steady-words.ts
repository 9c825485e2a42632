import { make } from './dom.js';

/** Words that change while nothing around them moves: the room of the longest is theirs from the beginning. */
export class SteadyWords {
  private readonly room: HTMLElement;

  /** @param shown what holds them, alone in an element of the class `steady` */
  constructor(private readonly shown: HTMLElement) {
    this.room = shown.parentElement!;
  }

  /** Keeps room for the largest of these from now on. */
  keepRoomFor(texts: readonly string[]): void {
    const unseen = texts.map((textContent) => {
      const words = make('span', { textContent });
      words.setAttribute('aria-hidden', 'true');
      return words;
    });
    this.room.replaceChildren(this.shown, ...unseen);
  }

  set text(text: string) {
    this.shown.textContent = text;
  }
}
