/**
 * The elements for pages that have no scripts of type `module`:
 *
 *     <script src="foldwright/foldwright-elements.js"></script>
 *
 * The modules of an element are fetched once the page has such an element, so that a page pays for no other.
 */
(() => {
  const { src } = document.currentScript;
  const missing = new Set(['foldwright-viewer', 'foldwright-studio']);

  const fetchWanted = () => {
    for (const name of missing) {
      if (!document.querySelector(name)) continue;
      missing.delete(name);
      import(new URL(`${name}.js`, src).href).catch((error) => {
        console.error(`<${name}> cannot be loaded:`, error);
      });
    }
    if (missing.size === 0) observer.disconnect();
  };

  const observer = new MutationObserver(fetchWanted);
  observer.observe(document, { childList: true, subtree: true });
  fetchWanted();
})();
