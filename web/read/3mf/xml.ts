/** Walks through XML without keeping it. */
import { SaxesParser, type SaxesAttributeNS } from 'saxes';

/** An element as it begins. */
export interface Element {
  /** Of its name's namespace. */
  uri: string;
  name: string;
  /** Value of an attribute without a namespace, or of the one given. */
  get: (name: string, uri?: string) => string | undefined;
  /** Address of the namespace with a prefix. */
  namespace: (prefix: string) => string | undefined;
}

export interface XmlListener {
  open(element: Element): void;
  close?(uri: string, name: string): void;
}

/** A document that breaks the rules of XML; `line` counts from 1. */
export class BadXml extends Error {
  constructor(readonly line: number) {
    super('bad XML');
  }
}

/** Letters that are parsed at a time: the parser keeps what it is given until it is through with it. */
const step = 1 << 20;

function textOf(bytes: Uint8Array): string {
  const isWide = bytes[0] === 0xff || bytes[0] === 0xfe;
  const label = !isWide ? 'utf-8' : bytes[0] === 0xff ? 'utf-16le' : 'utf-16be';
  return new TextDecoder(label).decode(bytes);
}

function find(attributes: SaxesAttributeNS[], name: string, uri: string): string | undefined {
  return attributes.find((each) => each.local === name && each.uri === uri)?.value;
}

/**
 * Tells all elements in their order; returns how to tell the line where that has got to.
 * @throws BadXml, and whatever the listener throws
 */
export function parseXml(
  bytes: Uint8Array,
  makeListener: (line: () => number) => XmlListener,
): void {
  const parser = new SaxesParser({ xmlns: true });
  const listener = makeListener(() => parser.line);
  parser.on('error', () => {
    throw new BadXml(parser.line);
  });
  parser.on('opentag', ({ uri, local, attributes }) => {
    const list = Object.values(attributes);
    listener.open({
      uri,
      name: local,
      get: (name, space = '') => find(list, name, space),
      namespace: (prefix) => parser.resolve(prefix),
    });
  });
  parser.on('closetag', ({ uri, local }) => listener.close?.(uri, local));
  const text = textOf(bytes);
  for (let at = 0; at < text.length; at += step) parser.write(text.slice(at, at + step));
  parser.close();
}
