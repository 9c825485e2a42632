/** Light and how it is shown (sRGB, IEC 61966-2-1); shares from 0 to 1. */

/** What screens show of a share of light. */
export function shownOf(light: number): number {
  return light <= 0.0031308 ? 12.92 * light : 1.055 * light ** (1 / 2.4) - 0.055;
}

/** The share of light that is shown so. */
export function lightOf(shown: number): number {
  return shown <= 0.04045 ? shown / 12.92 : ((shown + 0.055) / 1.055) ** 2.4;
}
