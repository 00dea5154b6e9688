// Programs of the film's shaders. The film's program puts "#version 330 core" in front of the sources;
// this file puts the dialect of WebGL 2 there.

const dialect = `#version 300 es
precision highp float;
precision highp int;
`;

/**
 * The functions that set a uniform of each type; matrices are column by column.
 * @type {[keyof WebGL2RenderingContext, (gl: WebGL2RenderingContext, at: WebGLUniformLocation | null, values: Iterable<number>) => void][]}
 */
const setters = [
  ['FLOAT', (gl, at, values) => gl.uniform1fv(at, values)],
  ['FLOAT_VEC2', (gl, at, values) => gl.uniform2fv(at, values)],
  ['FLOAT_VEC3', (gl, at, values) => gl.uniform3fv(at, values)],
  ['FLOAT_VEC4', (gl, at, values) => gl.uniform4fv(at, values)],
  ['FLOAT_MAT3', (gl, at, values) => gl.uniformMatrix3fv(at, false, values)],
  ['FLOAT_MAT4', (gl, at, values) => gl.uniformMatrix4fv(at, false, values)],
  ['INT', (gl, at, values) => gl.uniform1iv(at, values)],
];

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
    /** @type {Map<string, (values: Iterable<number>) => void>} */
    this.setters = new Map();
    const count = gl.getProgramParameter(this.program, gl.ACTIVE_UNIFORMS);
    for (let i = 0; i < count; ++i) this.#learn(/** @type {WebGLActiveInfo} */ (gl.getActiveUniform(this.program, i)));
  }

  /** A sampler keeps unit 0: no program reads two textures. @param {WebGLActiveInfo} uniform */
  #learn({ name, type }) {
    const { gl } = this,
      at = gl.getUniformLocation(this.program, name),
      set = setters.find(([kind]) => gl[kind] === type)?.[1];
    if (set) this.setters.set(name.replace('[0]', ''), (values) => set(gl, at, values));
  }

  /** Uses the program with these values of uniforms; those that no shader reads are ignored. @param {Record<string, number | Iterable<number>>} uniforms */
  use(uniforms) {
    this.gl.useProgram(this.program);
    for (const name in uniforms) {
      const value = uniforms[name];
      this.setters.get(name)?.(typeof value === 'number' ? [value] : value);
    }
  }
}

/** Interleaved float attributes of vertices, and the indices of triangles. */
export class VertexArray {
  /** @param {WebGL2RenderingContext} gl @param {number[]} sizes Components of the attributes 0, 1, ... */
  constructor(gl, sizes) {
    this.gl = gl;
    this.array = gl.createVertexArray();
    this.vertices = gl.createBuffer();
    this.indices = gl.createBuffer();
    this.bind();
    gl.bindBuffer(gl.ARRAY_BUFFER, this.vertices);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.indices);
    const stride = 4 * sizes.reduce((sum, size) => sum + size, 0);
    let offset = 0;
    sizes.forEach((size, location) => {
      gl.enableVertexAttribArray(location);
      gl.vertexAttribPointer(location, size, gl.FLOAT, false, stride, offset);
      offset += 4 * size;
    });
  }

  bind() {
    this.gl.bindVertexArray(this.array);
  }

  /** Binds it and replaces its contents. @param {Float32Array} vertices @param {Uint32Array} indices @param {number} usage */
  fill(vertices, indices, usage) {
    const { gl } = this;
    this.bind();
    gl.bindBuffer(gl.ARRAY_BUFFER, this.vertices);
    gl.bufferData(gl.ARRAY_BUFFER, vertices, usage);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, indices, usage);
  }

  free() {
    const { gl } = this;
    gl.deleteVertexArray(this.array);
    gl.deleteBuffer(this.vertices);
    gl.deleteBuffer(this.indices);
  }
}
