import catalogAddress from '/samples/catalog.json?url';
import { make } from './dom.js';
import { UnusableChoice, type ChosenModel } from './model-file.js';
import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';

/** An entry of the catalogue that is made with the samples. */
interface Sample {
  id: string;
  name: string;
  file: string;
  picture: string;
  faces: number;
}

/** The samples lie beside their catalogue, among the files of the studio, wherever the page comes from. */
function sampleAddress(name: string): string {
  return new URL(name, new URL(catalogAddress, location.href)).href;
}

async function fetchSample(name: string): Promise<Response> {
  const response = await fetch(sampleAddress(name)).catch(() => null);
  if (!response?.ok) {
    throw new UnusableChoice('The samples cannot be loaded. Models of your own work all the same.');
  }
  return response;
}

async function readSample({ file }: Sample): Promise<ChosenModel> {
  const response = await fetchSample(file);
  const bytes = new Uint8Array(await response.arrayBuffer());
  return { name: file, files: [{ name: file, bytes }] };
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
    this.list.replaceChildren(...samples.map((sample) => make('li', {}, this.tile(sample))));
  }

  /** Marks the sample with this file name as the chosen one; any other name marks none. */
  mark(fileName: string | null): void {
    for (const button of this.list.querySelectorAll('button')) {
      button.setAttribute('aria-pressed', String(button.value === fileName));
    }
  }

  private tile(sample: Sample): HTMLButtonElement {
    const picture = make('img', {
      src: sampleAddress(sample.picture),
      alt: '',
      width: 160,
      height: 160,
    });
    const button = make(
      'button',
      {
        type: 'button',
        className: 'sample',
        value: sample.file,
        title: `${sample.name}, ${sample.faces} faces`,
      },
      picture,
      sample.name,
    );
    button.setAttribute('aria-pressed', 'false');
    button.addEventListener('click', () => this.onChoice(readSample(sample)));
    return button;
  }
}
