/** Colours as files have them, as screens show them (sRGB, 0 to 255). */
import { shownOf } from '../model/srgb.js';

export type Colour = readonly [number, number, number];

export const white: Colour = [255, 255, 255];

/** A share of 255, whatever the number. */
function byteOf(share: number): number {
  return Math.round(255 * Math.min(1, Math.max(0, share || 0)));
}

/** Of shares that are as bright as they look (sRGB), from 0 to 1. */
export function ofShown(shares: readonly number[]): Colour {
  const [red = 0, green = 0, blue = 0] = shares;
  return [byteOf(red), byteOf(green), byteOf(blue)];
}

/** Of shares of light (linear), from 0 to 1. */
export function ofLight(shares: readonly number[]): Colour {
  return ofShown(shares.slice(0, 3).map(shownOf));
}
