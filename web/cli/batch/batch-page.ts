/** The page that shows what a batch has made. It needs no other file but those that it links to. */
import { base64 } from '../../export/texture/base64.js';
import { escaped } from '../../model/markup.js';
import { batchSummary, type BatchCounts } from '../../words/batch.js';
import { sizeWords } from '../../words/summary.js';
import type { Words } from '../../words/words.js';
import { pictureName } from './names.js';
import type { Fault, ModelRecord, Success } from './record.js';

/** A model on the page. */
export interface PageEntry {
  name: string;
  label: string;
  /** Null if it was not done yet. */
  record: ModelRecord | null;
  /** A PNG of 240 x 180 pixels. */
  picture: Uint8Array | null;
}

const style = `
:root { color-scheme: light dark; font: 16px/1.45 system-ui, sans-serif; }
body { margin: 0 auto; padding: 1.5rem; max-width: 84rem; }
h1 { font-size: 1.6rem; margin: 0; }
h2 { font-size: 1rem; margin: 0; overflow-wrap: anywhere; }
p { margin: 0.2rem 0; }
ul { list-style: none; margin: 1.5rem 0; padding: 0; }
.models { display: grid; gap: 1rem; grid-template-columns: repeat(auto-fill, minmax(15rem, 1fr)); }
.models > li { border: 1px solid #8886; border-radius: 0.5rem; padding: 0.8rem; }
img { display: block; width: 100%; height: auto; aspect-ratio: 4 / 3; background: #fff; border-radius: 0.3rem; margin-bottom: 0.5rem; }
.verdict::before { content: ''; display: inline-block; width: 0.7em; height: 0.7em; border-radius: 50%; margin-right: 0.4em; background: var(--level); }
.green { --level: #2e8b57; } .amber { --level: #e0a100; } .red { --level: #c62828; }
.faults { border-left: 0.3rem solid #c62828; padding-left: 1rem; }
.faults li { overflow-wrap: anywhere; margin: 0.3rem 0; }
a { margin-right: 0.6rem; white-space: nowrap; }
summary { cursor: pointer; }
`;

/** The address of a file in a model's folder, from the page. */
function addressOf(name: string, file: string): string {
  return escaped([...name.split('/'), file].map(encodeURIComponent).join('/'));
}

function links(name: string, { files }: Success): string {
  return files
    .filter(({ name: file }) => file !== pictureName(name))
    .map(({ name: file }) => `<a href="./${addressOf(name, file)}">${escaped(file)}</a>`)
    .join(' ');
}

function notes({ batch }: Words, { notices }: Success['summary']): string {
  if (notices.length === 0) return '';
  const lines = notices.map((text) => `<p>${escaped(text)}</p>`).join('');
  return `<details><summary>${escaped(batch.notices(notices.length))}</summary>${lines}</details>`;
}

function card(words: Words, { label, name, picture }: PageEntry, record: Success): string {
  const { batch } = words;
  const { building, pieces, sheets, size_mm: mm, verdict } = record.summary;
  const image = picture
    ? `<img alt="${escaped(batch.picture(label))}" loading="lazy" src="data:image/png;base64,${base64(picture)}">`
    : '';
  return [
    `<li>${image}<h2>${escaped(label)}</h2>`,
    `<p>${escaped(batch.amount({ pieces, sheets }))}, ${escaped(sizeWords(words, mm, '×'))}</p>`,
    `<p>${escaped(batch.building(building))}</p>`,
    `<p class="verdict ${verdict.level}">${escaped(verdict.text)}</p>`,
    `<p>${links(name, record)}</p>${notes(words, record.summary)}</li>`,
  ].join('\n');
}

function faultLine({ batch }: Words, { label }: PageEntry, record: Fault | null): string {
  const text = record?.text ?? batch.missing;
  const again = record?.status === 'failed' ? ` (${batch.failed})` : '';
  return `<li><strong>${escaped(label)}</strong>: ${escaped(text + again)}</li>`;
}

/** What the models have come to, whenever that was. */
function countsOf(entries: readonly PageEntry[]): BatchCounts {
  const count = (status: ModelRecord['status'] | undefined): number =>
    entries.filter(({ record }) => record?.status === status).length;
  return {
    all: entries.length,
    done: count('done'),
    skipped: 0,
    refused: count('refused'),
    failed: count('failed'),
    left: count(undefined),
  };
}

/** The page of some models, in their order; the same models and records give the same bytes. */
export function batchPage(words: Words, entries: readonly PageEntry[]): string {
  const { batch } = words;
  const cards: string[] = [];
  const faults: string[] = [];
  for (const entry of entries) {
    const { record } = entry;
    if (record?.status === 'done') cards.push(card(words, entry, record));
    else faults.push(faultLine(words, entry, record));
  }
  const list =
    faults.length === 0
      ? []
      : [
          '<section class="faults">',
          `<h2>${escaped(batch.faults)}</h2>`,
          `<ul>${faults.join('\n')}</ul>`,
          '</section>',
        ];
  return [
    '<!doctype html>',
    `<html lang="${words.code}"><head><meta charset="utf-8">`,
    '<meta name="viewport" content="width=device-width, initial-scale=1">',
    `<meta http-equiv="Content-Security-Policy" content="default-src 'none'; img-src data:; style-src 'unsafe-inline'">`,
    `<title>${escaped(batch.pageTitle)}</title><style>${style}</style></head><body>`,
    `<h1>${escaped(batch.pageTitle)}</h1>`,
    `<p>${escaped(batchSummary(words, countsOf(entries)))}</p>`,
    ...list,
    `<ul class="models">${cards.join('\n')}</ul>`,
    '</body></html>',
    '',
  ].join('\n');
}
