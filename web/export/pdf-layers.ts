import {
  PDFDict,
  PDFHexString,
  PDFName,
  type PDFDocument,
  type PDFPage,
  type PDFRef,
} from 'pdf-lib';
import { layers, layerTitles, type Layer } from './layers.js';

/** The layers of a document (optional content groups), which readers list and can hide. */
export class PdfLayers {
  private readonly groups = new Map<Layer, PDFRef>();

  constructor(private readonly document: PDFDocument) {}

  /** The name of a layer in the page's resources. */
  key(page: PDFPage, layer: Layer): PDFName {
    const { context } = this.document;
    const { Resources } = page.node.normalizedEntries();
    const slot = PDFName.of('Properties');
    const known = Resources.lookupMaybe(slot, PDFDict);
    const properties = known ?? context.obj({});
    if (!known) Resources.set(slot, properties);
    const key = PDFName.of(layer);
    properties.set(key, this.groupOf(layer));
    return key;
  }

  /** Tells the document of all layers that were used, those below first. */
  list(): void {
    const { catalog, context } = this.document;
    const all = layers.flatMap((layer) => this.groups.get(layer) ?? []);
    if (all.length === 0) return;
    const settings = { Name: PDFHexString.fromText('Layers'), Order: all, ON: all };
    catalog.set(PDFName.of('OCProperties'), context.obj({ OCGs: all, D: settings }));
  }

  private groupOf(layer: Layer): PDFRef {
    const known = this.groups.get(layer);
    if (known) return known;
    const { context } = this.document;
    const name = PDFHexString.fromText(layerTitles[layer]);
    const group = context.register(context.obj({ Type: 'OCG', Name: name }));
    this.groups.set(layer, group);
    return group;
  }
}
