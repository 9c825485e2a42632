// What all pages of this folder have in common; a page of the repository brings its own address.
export default {
  layout: 'page.njk',
  eleventyComputed: {
    permalink: (data) => data.permalink || `/${data.page.fileSlug || 'index'}.html`,
  },
};
