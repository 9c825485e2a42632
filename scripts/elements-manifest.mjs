// What the elements have, for editors, documentation and types of other people: made from the comments beside the code.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { create, ts } from '@custom-elements-manifest/analyzer';
import { root } from './setup/paths.mjs';

/** The class of each element, and the script of the package that defines it. */
const elements = [
  { source: 'web/element/viewer/viewer-element.ts', script: 'dist/package/foldwright-viewer.js' },
  { source: 'web/element/studio-element.ts', script: 'dist/package/foldwright-studio.js' },
];

/** Members of an interface that maps the names of events to their types, as the manifest has events. */
function eventsOf(map, source) {
  return map.members.map((member) => {
    const [comment] = member.jsDoc ?? [];
    return {
      name: member.name.text,
      type: { text: member.type.getText(source) },
      description: ts.getTextOfJSDocComment(comment?.comment),
    };
  });
}

/** Takes the events of each class from the interface beside it that types its listeners: the analyzer guesses worse. */
function eventMaps() {
  return {
    name: 'event-maps',
    analyzePhase({ node, moduleDoc }) {
      if (!ts.isInterfaceDeclaration(node) || !node.name.text.endsWith('EventMap')) return;
      moduleDoc.eventMap = eventsOf(node, node.getSourceFile());
    },
    moduleLinkPhase({ moduleDoc }) {
      for (const declaration of moduleDoc.declarations) {
        if (declaration.customElement) declaration.events = moduleDoc.eventMap;
      }
      delete moduleDoc.eventMap;
    },
  };
}

/** What others may rely on, and where they find it. */
function publicPart(declaration) {
  const members = declaration.members.filter(({ privacy }) => privacy !== 'private');
  const rank = ({ name }) => {
    const place = members.findIndex(({ attribute }) => attribute === name);
    return place < 0 ? members.length : place;
  };
  // In the order of the properties that reflect them; those without one are last.
  const attributes = [...declaration.attributes].sort((one, other) => rank(one) - rank(other));
  // A base class of its own is there only for pages that are made without a DOM.
  return { ...declaration, attributes, members, superclass: { name: 'HTMLElement' } };
}

function moduleOf({ declarations }, { script }) {
  const [element] = declarations.filter(({ customElement }) => customElement).map(publicPart);
  const to = { name: element.name, module: script };
  return {
    kind: 'javascript-module',
    path: script,
    declarations: [element],
    exports: [
      { kind: 'js', name: element.name, declaration: to },
      { kind: 'custom-element-definition', name: element.tagName, declaration: to },
    ],
  };
}

/**
 * @typedef {{ name: string, description: string }} Told
 * @typedef {Told & { fieldName?: string }} Attribute
 * @typedef {Told & { type: { text: string } }} Event
 * @typedef {Told & { kind: 'field' | 'method' }} Member
 * @typedef {{ tagName: string, attributes: Attribute[], events: Event[], members: Member[] }} Element what every one has
 */

/**
 * The manifest of all elements (custom-elements.json, schema 1.0.0).
 *
 * @returns {{ schemaVersion: string, readme: string, modules: { path: string, declarations: [Element] }[] }}
 */
export function elementsManifest() {
  const modules = elements.map(({ source }) => {
    const text = readFileSync(join(root, source), 'utf8');
    return ts.createSourceFile(source, text, ts.ScriptTarget.ES2022, true);
  });
  const { schemaVersion, modules: analyzed } = create({ modules, plugins: [eventMaps()] });
  const found = analyzed.map((module, i) => moduleOf(module, elements[i]));
  return { schemaVersion, readme: 'docs/elements.md', modules: found };
}
