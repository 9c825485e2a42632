/** Five by three pixels without losses; values of all four channels in a row are multiples of 37, modulo 256, or 255. */
export const webp = new Uint8Array(
  Buffer.from(
    'UklGRlYAAABXRUJQVlA4TEkAAAAvBIAAAHegFgACRqAF0Ju/ZBAK2UaA8QG8AFPINgKcErgPYEQ3/12YHhZY8oGlAJaCP1igIJIN6n1oq4IKRgUZlI3of+xnX9QIAA==',
    'base64',
  ),
);
