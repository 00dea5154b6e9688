/**
 * The compiled core and its memory. Numbers are passed in a scratch area of doubles: JavaScript writes
 * the arguments to its beginning, calls a function, and reads the results from the same place.
 *
 * A C++ exception is thrown as a {@link CoreError}. The C++ stack was not unwound, so the next call
 * replaces the instance by a new one. `generation` shows whether a pointer belongs to an old instance.
 */

/** An error of the C++ core: "WHAT: WHY", in the program's words. */
export class CoreError extends Error {
  /** @param {string} message */
  constructor(message) {
    super(message);
    this.name = 'CoreError';
    /** The subject of the error: "inertia", "tolerance", "method rk4". */
    this.quantity = message.split(':', 1)[0];
  }
}

/**
 * The exports of bindings.cpp.
 * @typedef {Record<string, (...values: number[]) => number> & {memory: WebAssembly.Memory}} Exports
 */

export class Instance {
  /** @param {WebAssembly.Module} module */
  constructor(module) {
    this.module = module;
    this.generation = 0;
    this.dead = true;
    /** @type {Exports} */
    this.exports = /** @type {any} */ (null);
    this.revive();
  }

  /** Makes a new instance if an exception ended the last one. */
  revive() {
    if (!this.dead) return;
    const nothing = () => 0;
    const names = WebAssembly.Module.imports(this.module);
    /** @type {WebAssembly.Imports} */
    const imports = {};
    for (const { module, name } of names) (imports[module] ??= {})[name] = nothing;
    imports.env = { ...imports.env, fail: (/** @type {number} */ text) => this.fail(text) };
    this.exports = /** @type {any} */ (new WebAssembly.Instance(this.module, imports).exports);
    this.exports._initialize?.();
    this.dead = false;
    ++this.generation;
  }

  /** @param {number} text @returns {never} */
  fail(text) {
    throw new CoreError(this.text(text));
  }

  /**
   * Calls an exported function.
   * @param {string} name
   * @param {number[]} values
   */
  call(name, ...values) {
    this.revive();
    try {
      return this.exports[name](...values);
    } catch (error) {
      this.dead = true;
      if (error instanceof WebAssembly.RuntimeError) {
        throw new CoreError(`core: stopped in ${name}: ${error.message}`);
      }
      throw error;
    }
  }

  /**
   * The scratch area with room for `count` doubles. Later calls may move it.
   * @param {number} count
   */
  scratch(count) {
    const begin = this.call('scratch', count);
    return new Float64Array(this.exports.memory.buffer, begin, count);
  }

  /**
   * Writes numbers to the scratch area and calls an exported function.
   * @param {ArrayLike<number>} numbers @param {string} name @param {number[]} values
   */
  callWith(numbers, name, ...values) {
    this.scratch(numbers.length).set(numbers);
    return this.call(name, ...values);
  }

  /**
   * Writes numbers to the scratch area, calls, and returns a copy of its first `count` numbers.
   * @param {number} count
   * @param {ArrayLike<number>} numbers
   * @param {string} name
   * @param {number[]} values
   */
  compute(count, numbers, name, ...values) {
    this.scratch(count);
    this.callWith(numbers, name, ...values);
    return this.scratch(count).slice();
  }

  /** The zero-terminated text at an address. @param {number} begin */
  text(begin) {
    const bytes = new Uint8Array(this.exports.memory.buffer);
    return new TextDecoder().decode(bytes.slice(begin, bytes.indexOf(0, begin)));
  }
}
