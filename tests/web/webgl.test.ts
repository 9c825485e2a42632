import { describe, expect, it } from 'vitest';
import { drawsInSoftware } from '../../web/view/webgl.js';

const rendererName = 0x9246;

/** A context that only tells who draws. */
function contextOf(renderer: string | null): WebGL2RenderingContext {
  return {
    getExtension: () => (renderer === null ? null : { UNMASKED_RENDERER_WEBGL: rendererName }),
    getParameter: (name: number) => (name === rendererName ? renderer : null),
  } as unknown as WebGL2RenderingContext;
}

describe('drawsInSoftware', () => {
  it.each([
    'ANGLE (Google, Vulkan 1.3.0 (SwiftShader Device (LLVM 10.0.0) (0x0000C0DE)), SwiftShader driver)',
    'Mesa/X.org, llvmpipe (LLVM 15.0.6, 256 bits)',
    'ANGLE (Microsoft, Microsoft Basic Render Driver Direct3D11 vs_5_0 ps_5_0)',
    'Apple Software Renderer',
  ])('knows %s', (renderer) => {
    expect(drawsInSoftware(contextOf(renderer))).toBe(true);
  });

  it.each([
    'ANGLE (NVIDIA, NVIDIA GeForce RTX 3060 Direct3D11 vs_5_0 ps_5_0)',
    'ANGLE (Intel, Mesa Intel(R) UHD Graphics 620 (KBL GT2), OpenGL 4.6)',
    'Apple M1',
    'Adreno (TM) 640',
    null,
  ])('takes %s for a graphics card', (renderer) => {
    expect(drawsInSoftware(contextOf(renderer))).toBe(false);
  });
});
