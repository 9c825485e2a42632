import type { JobEvent, JobResult, NetPicture } from '../model/job.js';
import { partColour } from '../model/part-colours.js';
import { finishedNet } from '../view/finished-net.js';
import { openPicture } from '../view/picture.js';
import { make } from './dom.js';
import { Panel } from './panel.js';

/** The net that is being searched, and a chip for each part, filled when its net is found. */
export class NetPanel extends Panel {
  private readonly words = this.find('#net-words', HTMLElement);
  private readonly chips = this.find('#net-chips', HTMLElement);
  private net: NetPicture | null = null;
  private part = 0;
  private labels: Int32Array | null = null;
  private hatched = false;
  private readonly picture = openPicture(this.find('#net', HTMLElement), this.place.life);

  clear(): void {
    this.net = null;
    this.labels = null;
    this.words.textContent = this.told.pictures.netToCome;
    this.chips.replaceChildren();
    this.draw();
  }

  /** Takes the parts of the faces in. */
  paint(labels: Int32Array): void {
    this.labels = labels;
    const parts = labels.reduce((most, label) => Math.max(most, label + 1), 0);
    for (let part = this.chips.children.length; part < parts; ++part) this.addChip(part);
    this.words.textContent = this.told.pictures.netBegins;
  }

  hatch(hatched: boolean): void {
    this.hatched = hatched;
    this.draw();
  }

  follow({ part, generation, overlaps, net }: Extract<JobEvent, { type: 'generation' }>): void {
    // The words are about the picture, which does not come with every generation.
    if (!net && this.net) return;
    this.words.textContent = this.told.pictures.generation(part + 1, generation, overlaps);
    if (!net) return;
    this.part = part;
    this.net = net;
    this.draw();
  }

  /** Shows the largest of the nets that came out. */
  finish({ pieces, labels }: JobResult): void {
    const [largest] = [...pieces].sort((a, b) => b.sources.length - a.sources.length);
    if (!largest) return;
    this.paint(labels);
    for (const { part } of pieces) this.found(part);
    this.words.textContent = this.told.pictures.netDone(largest.part + 1);
    this.net = finishedNet(largest);
    this.draw();
  }

  /** Fills the chip of a part that has a net now. */
  found(part: number): void {
    while (this.chips.children.length <= part) this.addChip(this.chips.children.length);
    this.chips.children[part]?.classList.add('chip--found');
  }

  private draw(): void {
    const { net, labels, hatched } = this;
    if (!net) {
      this.picture.post({ type: 'nothing' });
      return;
    }
    const parts = net.sources.map((face) => labels?.[face] ?? this.part);
    this.picture.post({ type: 'net', net, parts, hatched });
  }

  private addChip(part: number): void {
    const chip = make('span', { className: 'chip' });
    chip.style.setProperty('--colour', partColour(part));
    this.chips.append(chip);
  }
}
