// The order in which pages are offered, as addresses; a test holds that every page is here, but for those of the API.
export const navigation = [
  {
    title: 'Begin',
    pages: [
      '/index.html',
      '/start.html',
      '/showcase.html',
      '/crafting.html',
      '/machines.html',
      '/limits.html',
    ],
  },
  {
    title: 'Use',
    pages: [
      '/overview.html',
      '/options.html',
      '/documents.html',
      '/batches.html',
      '/comparison.html',
    ],
  },
  {
    title: 'In pages and programs',
    pages: [
      '/live.html',
      '/elements.html',
      '/package.html',
      '/api/index.html',
      '/versions.html',
      '/changelog.html',
    ],
  },
  {
    title: 'How it works',
    pages: [
      '/how.html',
      '/learning.html',
      '/clustering.html',
      '/search.html',
      '/how-folding.html',
      '/how-paper.html',
    ],
  },
  {
    title: 'In depth',
    pages: [
      '/repair.html',
      '/simplification.html',
      '/parts.html',
      '/folding.html',
      '/paper.html',
      '/architecture.html',
      '/contributing.html',
    ],
  },
];
