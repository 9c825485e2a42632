/** Where the build has put the files that are fetched when they are first needed, as pages know it. */
import webp from '@jsquash/webp/codec/dec/webp_dec.wasm?url';
import resvg from '@resvg/resvg-wasm/index_bg.wasm?url';
import { assetLoader, type AssetAddresses } from './asset-loader.js';

const fonts = import.meta.glob<string>(
  [
    '../../node_modules/@fontsource/noto-sans/files/noto-sans-*-400-normal.woff',
    '!../../node_modules/@fontsource/noto-sans/files/noto-sans-devanagari-*',
    '../../node_modules/@fontsource/biz-udpgothic/files/biz-udpgothic-[0-9]*-400-normal.woff',
  ],
  { query: '?url', import: 'default', eager: true },
);

/**
 * Workers are told these by their page: bundlers that take up the package copy the scripts of workers as they are, so
 * that these do not find what lay beside them.
 */
export const pageAssets: AssetAddresses = {
  fonts: Object.fromEntries(
    Object.entries(fonts).map(([path, address]) => [path.replace(/.*\//, ''), address]),
  ),
  renderers: { resvg, webp },
};

export const pageLoader = assetLoader(pageAssets);
