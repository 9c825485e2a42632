// Which files of the repository are pages of the site as they are, and which are copied because pages link to them.

/** Markdown files by their paths, with the address that each has on the site. */
export const repositoryPages = {
  'README.md': '/overview.html',
  'CHANGELOG.md': '/changelog.html',
  'CONTRIBUTING.md': '/contributing.html',
  'docs/architecture.md': '/architecture.html',
  'docs/batches.md': '/batches.html',
  'docs/documents.md': '/documents.html',
  'docs/elements.md': '/elements.html',
  'docs/folding.md': '/folding.html',
  'docs/package.md': '/package.html',
  'docs/paper.md': '/paper.html',
  'docs/repair.md': '/repair.html',
  'docs/segmentation.md': '/parts.html',
  'docs/simplification.md': '/simplification.html',
  'docs/versions.md': '/versions.html',
};

/** Titles for readers who have not seen the repository, where the heading of the file is not one. */
export const titles = { 'README.md': 'Overview', 'docs/package.md': 'The package' };

/** Other files that pages link to or show, by their paths. */
export const copiedFiles = {
  LICENSE: '/files/LICENSE.txt',
  'docs/studio.png': '/files/studio.png',
  'web/export/batch.schema.json': '/files/batch.schema.json',
};
