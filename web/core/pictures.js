/** The contents of the page's views. C++ computes them (src/picture); this file reads its memory. */
/** @import { Core } from './core.js' */
/** @import { Instance } from './instance.js' */
/** @import { Motion } from './motion.js' */
/** @import { Camera, Contents, DrawList, Samples, Settings, Triangles, Viewpoint } from './types' */

const floatsOfVertex = 11,
  numbersOfLabel = 8;

/** Reads results one after another. */
class Reader {
  /** @param {Instance} instance @param {Float64Array} numbers */
  constructor(instance, numbers) {
    this.instance = instance;
    this.numbers = numbers;
    this.next = 0;
  }

  number() {
    return this.numbers[this.next++];
  }

  /** @param {number} count */
  several(count) {
    return Array.from({ length: count }, () => this.number());
  }

  /** @returns {Camera} */
  camera() {
    return { attitude: this.several(9), distance: this.number(), projection: this.several(16) };
  }

  /** @returns {Triangles} */
  triangles() {
    const { exports } = this.instance,
      [faces, faceCount, edgeQuads, edgeQuadCount] = this.several(4);
    return {
      get faces() {
        return new Uint32Array(exports.memory.buffer, faces, faceCount);
      },
      get edgeQuads() {
        return new Uint32Array(exports.memory.buffer, edgeQuads, edgeQuadCount);
      },
    };
  }

  /** @returns {DrawList} */
  list() {
    const { exports } = this.instance,
      [begin, count] = this.several(2);
    return {
      get vertices() {
        return new Float32Array(exports.memory.buffer, begin, floatsOfVertex * count);
      },
      items: this.triangles(),
      outlines: this.triangles(),
      ghosts: this.triangles(),
    };
  }
}

export class Pictures {
  /** @param {Core} core */
  constructor({ instance }) {
    this.instance = instance;
    const lines = instance.text(instance.call('picture_names')).split('\n');
    const [settings, themes, frames, features, insets] = lines.map((line) => line.trim().split(' '));
    this.names = { settings, themes, frames, features, insets };
  }

  /** A bit for each of these features. @param {readonly string[]} features */
  #bits(features) {
    return features.reduce((bits, feature) => bits | (1 << this.names.features.indexOf(feature)), 0);
  }

  /**
   * Calls a function of the core with a motion, settings, one or two motions at the same time, each with
   * its trail, and other numbers.
   * @param {string} name @param {Motion} motion @param {Settings} settings @param {Samples[]} instants
   * @param {number[]} rest
   */
  #call(name, motion, settings, instants, ...rest) {
    const pointer = motion.held.get();
    /** @type {Record<string, any>} */
    const named = {
      ...settings,
      theme: this.names.themes.indexOf(settings.theme),
      frame: this.names.frames.indexOf(settings.frame),
      show: this.#bits(settings.show),
      stress: this.#bits(settings.stress),
    };
    const numbers = [...this.names.settings.map((setting) => named[setting]), instants.length];
    const scratch = this.instance.scratch(
      instants.reduce((sum, { t }) => sum + 1 + 13 * t.length, numbers.length),
    );
    scratch.set(numbers);
    let at = numbers.length;
    for (const { t, X, omega } of instants) {
      scratch[at++] = t.length;
      for (const values of [t, X, omega]) {
        scratch.set(values, at);
        at += values.length;
      }
    }
    return this.instance.call(name, pointer, ...rest);
  }

  /** @returns {Contents} */
  #contents() {
    const { instance } = this,
      { byteOffset } = instance.scratch(64),
      reader = new Reader(instance, new Float64Array(instance.exports.memory.buffer, byteOffset));
    const camera = reader.camera();
    const clipZNearer = reader.number(),
      opaque = reader.list(),
      translucent = reader.list(),
      labels = Array.from({ length: reader.number() }, () => {
        const n = reader.several(numbersOfLabel);
        return { text: instance.text(n[7]), anchor: n.slice(0, 2), away: n.slice(2, 4), color: n.slice(4, 7) };
      });
    return { camera, clipZNearer, opaque, translucent, labels };
  }

  /** The body with its arrows. @param {Motion} motion @param {Settings} settings @param {Viewpoint} from @param {Samples} instant */
  body(motion, settings, { azimuth, elevation, zoom }, instant) {
    this.#call('show_body', motion, settings, [instant], azimuth, elevation, zoom);
    return this.#contents();
  }

  /** The stars of a theme: direction, brightness and tint of each. @param {number} count of those in the default camera's picture */
  stars(count) {
    return floatsAt(this.instance, this.instance.call('theme_stars', count));
  }

  /** An inset. @param {string} name @param {Motion} motion @param {Settings} settings @param {Viewpoint} from @param {Samples[]} instants One, or two to compare. */
  inset(name, motion, settings, { azimuth, elevation, zoom }, instants) {
    const index = this.names.insets.indexOf(name);
    this.#call('show_inset', motion, settings, instants, index, azimuth, elevation, zoom);
    return this.#contents();
  }

  /**
   * Calls a function of the core that returns numbers.
   * @param {number} count @param {string} name @param {Motion} motion @param {Settings} settings @param {number[]} rest
   */
  #numbers(count, name, motion, settings, ...rest) {
    this.#call(name, motion, settings, [], ...rest);
    return [...this.instance.scratch(count)];
  }

  /** The direction from which an inset shows a motion best. @param {string} name @param {Motion} motion @param {Settings} settings */
  home(name, motion, settings) {
    const index = this.names.insets.indexOf(name),
      [azimuth, elevation] = this.#numbers(2, 'inset_home', motion, settings, index);
    return { azimuth, elevation };
  }

  /** Where the start of the motion is on the sphere, in pixels. @param {Motion} motion @param {Settings} settings @param {Viewpoint} from */
  start(motion, settings, { azimuth, elevation, zoom }) {
    return this.#numbers(2, 'sphere_start', motion, settings, azimuth, elevation, zoom);
  }

  /**
   * The omega with which the motion starts at a place in the picture of the sphere.
   * @param {Motion} motion @param {Settings} settings @param {Viewpoint} from
   * @param {number[]} place -1 to 1 across and up
   */
  omegaAt(motion, settings, { azimuth, elevation, zoom }, [x, y]) {
    return this.#numbers(3, 'sphere_omega_at', motion, settings, azimuth, elevation, zoom, x, y);
  }

  /**
   * The omega of a start that is moved by the angles `way`, in rad.
   * @param {Motion} motion @param {Settings} settings @param {Viewpoint} from @param {number[]} way across and up
   */
  omegaMoved(motion, settings, { azimuth, elevation, zoom }, [right, up]) {
    return this.#numbers(3, 'sphere_omega_moved', motion, settings, azimuth, elevation, zoom, right, up);
  }
}

/** Floats that C++ wrote to memory; their address and their number are in the scratch area. @param {Instance} instance @param {number} begin */
export function floatsAt(instance, begin) {
  const [count] = instance.scratch(1);
  return new Float32Array(instance.exports.memory.buffer, begin, count);
}
