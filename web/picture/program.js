// Programs of the film's shaders: one source, of which the film's program puts "#version 330 core"
// in front, and this one the dialect of WebGL 2.

const dialect = `#version 300 es
precision highp float;
precision highp int;
`;

/**
 * @param {WebGL2RenderingContext} gl @param {number} stage @param {string[]} files
 */
function compiled(gl, stage, files) {
  const shader = /** @type {WebGLShader} */ (gl.createShader(stage));
  gl.shaderSource(shader, dialect + files.join('\n'));
  gl.compileShader(shader);
  if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS) && !gl.isContextLost()) {
    throw new Error(`A shader does not compile: ${gl.getShaderInfoLog(shader)}`);
  }
  return shader;
}

export class Program {
  /**
   * @param {WebGL2RenderingContext} gl
   * @param {string[]} vertex The texts of the vertex shader's files.
   * @param {string[]} fragment
   */
  constructor(gl, vertex, fragment) {
    this.gl = gl;
    this.program = /** @type {WebGLProgram} */ (gl.createProgram());
    for (const shader of [
      compiled(gl, gl.VERTEX_SHADER, vertex),
      compiled(gl, gl.FRAGMENT_SHADER, fragment),
    ]) {
      gl.attachShader(this.program, shader);
      gl.deleteShader(shader);
    }
    gl.linkProgram(this.program);
    if (!gl.getProgramParameter(this.program, gl.LINK_STATUS) && !gl.isContextLost()) {
      throw new Error(`A shader program does not link: ${gl.getProgramInfoLog(this.program)}`);
    }
    /** @type {Map<string, WebGLUniformLocation | null>} */
    this.locations = new Map();
  }

  use() {
    this.gl.useProgram(this.program);
  }

  /** @param {string} name */
  #at(name) {
    let location = this.locations.get(name);
    if (location === undefined) {
      location = this.gl.getUniformLocation(this.program, name);
      this.locations.set(name, location);
    }
    return location;
  }

  /**
   * Sets a uniform of one to four components, by their number, or an array of vec4.
   * @param {string} name @param {number | ArrayLike<number>} value
   */
  set(name, value) {
    const { gl } = this;
    if (typeof value === 'number') {
      gl.uniform1f(this.#at(name), value);
      return;
    }
    const values = Float32Array.from(value);
    if (values.length === 2) gl.uniform2fv(this.#at(name), values);
    else if (values.length === 3) gl.uniform3fv(this.#at(name), values);
    else gl.uniform4fv(this.#at(name), values);
  }

  /** @param {string} name @param {number} unit of the texture */
  setTexture(name, unit) {
    this.gl.uniform1i(this.#at(name), unit);
  }

  /** Sets a matrix of 9 or 16 numbers, column by column. @param {string} name @param {Float32Array} m */
  setColumns(name, m) {
    const { gl } = this;
    if (m.length === 9) gl.uniformMatrix3fv(this.#at(name), false, m);
    else gl.uniformMatrix4fv(this.#at(name), false, m);
  }

  /** Sets a matrix of 9 numbers, row by row. @param {string} name @param {ArrayLike<number>} m */
  setRows(name, m) {
    this.gl.uniformMatrix3fv(this.#at(name), true, Float32Array.from(m));
  }
}

/**
 * Describes interleaved float attributes of the bound buffer to the bound vertex array.
 * @param {WebGL2RenderingContext} gl @param {number[]} sizes Components of the attributes 0, 1, ...
 */
export function setAttributes(gl, sizes) {
  const stride = 4 * sizes.reduce((sum, size) => sum + size, 0);
  let offset = 0;
  sizes.forEach((size, location) => {
    gl.enableVertexAttribArray(location);
    gl.vertexAttribPointer(location, size, gl.FLOAT, false, stride, offset);
    offset += 4 * size;
  });
}
