/** Reads the values of a PDO file one after the other: little-endian, without gaps between them. */

/** The file contradicts itself or ends too early; `at` is the byte where that shows. */
export class BrokenPdo extends Error {
  constructor(readonly at: number) {
    super(`byte ${at}`);
  }
}

export class PdoBytes {
  private readonly view: DataView;
  private next = 0;

  constructor(private readonly bytes: Uint8Array) {
    this.view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  }

  /** Where the next value stands. */
  get at(): number {
    return this.next;
  }

  get left(): number {
    return this.bytes.length - this.next;
  }

  bool(): boolean {
    return this.bytes[this.taken(1)] !== 0;
  }

  u32(): number {
    return this.view.getUint32(this.taken(4), true);
  }

  i32(): number {
    return this.view.getInt32(this.taken(4), true);
  }

  f32(): number {
    return this.view.getFloat32(this.taken(4), true);
  }

  f64(): number {
    return this.view.getFloat64(this.taken(8), true);
  }

  /** A view of the next bytes. */
  block(length: number): Uint8Array {
    const begin = this.taken(length);
    return this.bytes.subarray(begin, begin + length);
  }

  skip(length: number): void {
    this.taken(length);
  }

  /**
   * A count of things to come.
   *
   * @param least bytes that each of them takes at least, so that no more are announced than the file can hold
   */
  count(least: number): number {
    const begin = this.next;
    const count = this.u32();
    if (count * least > this.left) throw new BrokenPdo(begin);
    return count;
  }

  /** @throws BrokenPdo for bytes beyond the end */
  private taken(length: number): number {
    if (length > this.left) throw new BrokenPdo(this.next);
    const begin = this.next;
    this.next += length;
    return begin;
  }
}
