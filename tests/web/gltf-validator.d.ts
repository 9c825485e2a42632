/** The part of the validator that the tests use; it comes without types. */
declare module 'gltf-validator' {
  interface Message {
    code: string;
    message: string;
    pointer?: string;
  }

  interface Report {
    issues: { numErrors: number; numWarnings: number; messages: Message[] };
    info: { animationCount: number; materialCount: number; totalTriangleCount: number };
  }

  export function validateBytes(bytes: Uint8Array): Promise<Report>;
}
