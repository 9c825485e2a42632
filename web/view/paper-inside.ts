import { Color, type WebGLProgramParametersWithUniforms } from 'three';

/** The inside of the paper, which nothing is printed on. */
const inside = new Color('#f2ebdc');

/** Leaves the inside of faces blank, in a material that draws both of their sides. */
export function leaveInsideBlank(shader: WebGLProgramParametersWithUniforms): void {
  shader.uniforms['inside'] = { value: inside };
  shader.fragmentShader = shader.fragmentShader
    .replace('#include <common>', `uniform vec3 inside;\n$&`)
    .replace('#include <color_fragment>', `$&\nif (!gl_FrontFacing) diffuseColor.rgb = inside;`);
}
