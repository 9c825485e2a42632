import addresses from 'virtual:sample-addresses';
import { difficultyOf } from '../model/building-time.js';
import type { ModelFile } from '../model/model-files.js';
import type { Words } from '../words/words.js';
import { make } from './dom.js';
import { UnusableChoice, type ChosenModel } from './model-file.js';
import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';

/** An entry of the catalogue that is made with the samples. */
interface Sample {
  id: string;
  name: string;
  /** The model. */
  file: string;
  /** The model and its materials. */
  files: string[];
  picture: string;
  faces: number;
  /** What it takes to build it as it comes, if the engine has been asked: see `scripts/time-samples.mjs`. */
  building?: { pieces: number; seconds: number };
}

/** The samples lie among the files of the studio, wherever the page comes from. */
function sampleAddress(name: string): string {
  return addresses[name] ?? name;
}

/** "Easy: 3 pieces" and "about 40 minutes" */
function effortWords(
  { building, choice }: Words,
  { pieces, seconds }: NonNullable<Sample['building']>,
): string[] {
  return [choice.effort(difficultyOf(seconds), pieces), building.duration({ seconds })];
}

/** What a sample is called in a language; by its catalogue if that is newer than the words. */
function nameOf({ samples }: Words, { id, name }: Sample): string {
  return Object.hasOwn(samples, id) ? samples[id as keyof typeof samples] : name;
}

async function fetchSample(name: string): Promise<Response> {
  const response = await fetch(sampleAddress(name)).catch(() => null);
  if (!response?.ok) {
    throw new UnusableChoice(({ choice }) => choice.noSamples);
  }
  return response;
}

async function readFile(name: string): Promise<ModelFile> {
  const response = await fetchSample(name);
  return { name, bytes: new Uint8Array(await response.arrayBuffer()) };
}

async function readSample({ file, files }: Sample): Promise<ChosenModel> {
  return { name: file, files: await Promise.all(files.map(readFile)) };
}

/** The pictures of the samples; one press chooses a sample. */
export class SampleGallery extends Panel {
  private readonly list = this.find('#samples', HTMLUListElement);

  constructor(
    place: StudioPlace,
    private readonly onChoice: (model: Promise<ChosenModel>) => void,
  ) {
    super(place);
  }

  /** Loads the catalogue and shows it. Throws UnusableChoice. */
  async load(): Promise<void> {
    const response = await fetchSample('catalog.json');
    const samples = (await response.json()) as Sample[];
    this.list.replaceChildren(...samples.map((sample) => this.item(sample)));
  }

  /** Marks the sample with this file name as the chosen one; any other name marks none. */
  mark(fileName: string | null): void {
    for (const button of this.list.querySelectorAll('button')) {
      button.setAttribute('aria-pressed', String(button.value === fileName));
    }
  }

  /** What it takes to build it stands over its button: it describes what the button chooses, and is not its name. */
  private item(sample: Sample): HTMLLIElement {
    const button = this.tile(sample);
    const item = make('li', {}, button);
    if (!sample.building) return item;
    const effort = make(
      'p',
      { className: 'sample__effort', id: `effort-${sample.id}` },
      ...effortWords(this.told, sample.building).map((textContent) =>
        make('span', { textContent }),
      ),
    );
    button.setAttribute('aria-describedby', effort.id);
    item.append(effort);
    return item;
  }

  private tile(sample: Sample): HTMLButtonElement {
    const picture = make('img', {
      src: sampleAddress(sample.picture),
      alt: '',
      width: 160,
      height: 160,
    });
    const name = nameOf(this.told, sample);
    const button = make(
      'button',
      {
        type: 'button',
        className: 'sample',
        value: sample.file,
        title: this.told.choice.sample(name, sample.faces),
      },
      picture,
      name,
    );
    button.setAttribute('aria-pressed', 'false');
    button.addEventListener('click', () => this.onChoice(readSample(sample)));
    return button;
  }
}
