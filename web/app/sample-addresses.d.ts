/** Written by the build, see `sampleAddresses` in `scripts/make/vite-plugins.mjs`. */
declare module 'virtual:sample-addresses' {
  /** Of the catalogue, the models, their materials and their pictures, by the names of their files. */
  const addresses: Readonly<Record<string, string>>;
  export default addresses;
}
