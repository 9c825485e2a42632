/** The part of the encoder that tests use; the package has no types of its own. */
declare module 'draco3dgltf' {
  const draco: { createEncoderModule(): Promise<object> };
  export default draco;
}
