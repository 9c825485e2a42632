/** A demonstration on a page: fields, a button, pictures and a line of words around a real run. */
import type { Demo, Field, Show } from './demo.js';
import { loadPackage, loadSample, samples } from './engine.js';

const model: Field = { name: 'model', title: 'Model', kind: 'choice', choices: samples };

function inputOf(field: Field): HTMLElement {
  if (field.kind === 'number') {
    const input = document.createElement('input');
    const { value, least, most } = field;
    Object.assign(input, { type: 'number', min: least, max: most, required: true });
    input.defaultValue = String(value);
    input.name = field.name;
    return input;
  }
  const select = document.createElement('select');
  select.name = field.name;
  select.append(...Object.entries(field.choices).map(([value, text]) => new Option(text, value)));
  return select;
}

function labelled(field: Field): HTMLLabelElement {
  const label = document.createElement('label');
  label.append(`${field.title} `, inputOf(field));
  return label;
}

function button(text: string, type: 'submit' | 'button'): HTMLButtonElement {
  return Object.assign(document.createElement('button'), { textContent: text, type });
}

/** A class for each demonstration, since an element has one kind. */
export function demoElement(demo: Demo): typeof HTMLElement {
  return class extends HTMLElement {
    private run: AbortController | null = null;
    private readonly form = document.createElement('form');
    private readonly stop = button('Stop', 'button');
    private readonly pictures = document.createElement('div');
    private readonly status = document.createElement('p');

    connectedCallback(): void {
      if (this.form.isConnected) return;
      this.pictures.className = 'demo__pictures';
      this.status.setAttribute('role', 'status');
      this.stop.disabled = true;
      this.form.append(...[model, ...demo.fields].map(labelled));
      this.form.append(button(demo.action, 'submit'), this.stop);
      this.replaceChildren(this.form, this.pictures, this.status);
      const show = demo.begin(this.pictures);
      this.form.addEventListener('submit', (event) => {
        event.preventDefault();
        void this.begin(show);
      });
      this.stop.addEventListener('click', () => this.run?.abort());
    }

    disconnectedCallback(): void {
      this.run?.abort();
    }

    /** One run from its beginning to its end; another one that is under way is ended. */
    private async begin(show: Show): Promise<void> {
      this.run?.abort();
      const run = (this.run = new AbortController());
      show.clear();
      this.say('Loading the engine');
      this.stop.disabled = false;
      try {
        await this.unfold(show, run);
      } catch (error) {
        if (!run.signal.aborted) this.say(String(error));
        else if (run.signal.reason !== 'shown') this.say('Stopped');
      } finally {
        if (this.run === run) this.stop.disabled = true;
      }
    }

    private async unfold(show: Show, run: AbortController): Promise<void> {
      const values = Object.fromEntries(new FormData(this.form)) as Record<string, string>;
      const [{ unfold }, file] = await Promise.all([loadPackage(), loadSample(values['model']!)]);
      run.signal.throwIfAborted();
      await unfold([file], show.options(values), {
        signal: run.signal,
        pictures: true,
        onEvent: (event) => {
          if (run.signal.aborted) return;
          const { words, isDone } = show.take(event);
          if (words !== undefined) this.say(words);
          if (isDone) run.abort('shown');
        },
      });
    }

    private say(words: string): void {
      this.status.textContent = words;
    }
  };
}
