/** How far coordinates were rounded when they were written; as `CoordinatePrecision` of the engine tells it. */

/** Half the distance between neighbouring numbers around `value` whose mantissa has `bits` bits. */
export function halfSpacing(value: number, bits: number): number {
  return value === 0 ? 0 : 2 ** (Math.floor(Math.log2(Math.abs(value))) - bits);
}

export const bitsOfSingle = 24;
export const bitsOfDouble = 53;

/** Magnitude of the largest coordinate. */
export function largestOf(values: ArrayLike<number>): number {
  let largest = 0;
  for (let i = 0; i < values.length; ++i) largest = Math.max(largest, Math.abs(values[i]!));
  return largest;
}

/** Whether a person or a grid is likely to have chosen the number, which then is exact. */
function isChosen(value: number): boolean {
  return Number.isInteger(64 * value);
}

/** Rounding errors of numbers that are written as text. */
export class TextPrecision {
  private largest = 0;
  private allChosen = true;
  private allSingle = true;
  private mostDecimals = -Infinity;
  private mostDigits = 0;
  private topDecade = -Infinity;
  /** Of the numbers with the most digits. */
  private decades: [number, number] = [0, 0];

  /** @param word of a finite number */
  add(word: string, value: number): void {
    // A zero is exact, however it is written.
    if (value === 0) return;
    const [mantissa = '', exponent = '0'] = word.toLowerCase().split('e');
    const [, whole = '', fraction = ''] = /^\s*[-+]?(\d*)\.?(\d*)/.exec(mantissa) ?? [];
    const decimals = fraction.length - Number(exponent);
    this.count((whole + fraction).replace(/^0+/, '').length, decimals);
    this.largest = Math.max(this.largest, Math.abs(value));
    this.allChosen &&= isChosen(value);
    this.allSingle &&= Math.abs(value - Math.fround(value)) <= 0.5 * 10 ** -decimals;
  }

  private count(digits: number, decimals: number): void {
    const decade = digits - decimals - 1;
    this.mostDecimals = Math.max(this.mostDecimals, decimals);
    this.topDecade = Math.max(this.topDecade, decade);
    if (digits > this.mostDigits) {
      this.mostDigits = digits;
      this.decades = [decade, decade];
    } else if (digits === this.mostDigits) {
      this.decades = [Math.min(this.decades[0], decade), Math.max(this.decades[1], decade)];
    }
  }

  /** Largest rounding error; 0 for numbers that are exact. */
  get error(): number {
    if (this.allChosen || this.mostDigits === 0) return 0;
    // Programs that print a fixed number of digits reach it in several powers of ten; "%g" writes 6.
    const hasFixedDigits = this.mostDigits >= 6 && this.decades[0] < this.decades[1];
    const decimals = hasFixedDigits ? this.mostDigits - 1 - this.topDecade : this.mostDecimals;
    const single = this.allSingle ? halfSpacing(this.largest, bitsOfSingle) : 0;
    return Math.max(0.5 * 10 ** -decimals, single);
  }
}
