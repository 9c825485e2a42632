import type { DrawnFormat } from '../export/formats.js';
import type { PrintedPage } from '../export/printed-pages.js';
import type { Notice } from '../model/job.js';
import type { SheetRange } from '../model/sheet-range.js';
import { pixelExcess } from '../model/pixels.js';
import type { PrintOptions } from '../model/print-options.js';
import type { OptionFault } from '../words/messages.js';
import type { ExportedFile } from './exporters.js';
import type { WriterHost } from './writer-host.js';
import type { WriterSource } from './writer-worker.js';

/** Writes one result, in the worker that writes all of a studio's. */
export class ResultWriter {
  /** @param options how the sheets look; may be changed between orders */
  constructor(
    private readonly host: WriterHost,
    private readonly source: WriterSource,
    public options: PrintOptions,
  ) {}

  /** One sheet, counted from 0, as SVG. */
  sheet(sheet: number): Promise<string> {
    return this.host.order(this.source, { type: 'sheet', sheet, options: this.options });
  }

  /** The sheets that are wanted of the result in a format. */
  file(format: DrawnFormat, only: SheetRange): Promise<ExportedFile> {
    return this.host.order(this.source, { type: 'file', format, only, options: this.options });
  }

  /** All pages as they are printed. */
  pages(): Promise<PrintedPage[]> {
    return this.host.order(this.source, { type: 'pages', options: this.options });
  }

  /** Why the result cannot be written in a format as it shall look; null if it can. */
  obstacle(format: DrawnFormat): OptionFault | null {
    if (format !== 'png') return null;
    const { dpi } = this.options;
    for (const { width, height } of this.source.result.sheets) {
      const excess = pixelExcess(width, height, dpi);
      if (excess !== null) return { what: 'pixels', ...excess };
    }
    return null;
  }

  /** What a person should know of the sheets beside what the job told. */
  notices(): Promise<Notice[]> {
    return this.host.order(this.source, { type: 'notices', options: this.options });
  }

  /** Lets the worker forget the result. What was asked for still comes. */
  close(): void {
    this.host.forget(this.source);
  }
}
