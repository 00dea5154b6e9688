// The page's WebGL 2 context. Browsers limit the number of contexts, so all views share this one: they draw
// into its hidden canvas one after another, and each copies its picture to its own canvas.
import { byId, showNote } from '../app/dom.js';
import { word } from '../words/words.js';
import { BodyPass } from './body_pass.js';
import { DrawListPass } from './draw_list_pass.js';
import { Ground } from './ground.js';
import { Stars } from './stars.js';

/** @import { Core } from '../core/core.js' */
/** @import { Surface } from '../app/types' */

const mostBodies = 2; // kept for the views that are on the screen together

/** The objects of a context, without those of bodies. @param {WebGL2RenderingContext} gl */
const objectsOf = (gl) => ({
  lists: new DrawListPass(gl),
  ground: new Ground(gl),
  stars: new Stars(gl),
  starCount: 0, // that of the theme whose stars are placed
  /** @type {{surface: Surface, theme: any, pass: BodyPass}[]} The last one used comes last. */
  bodies: [],
});

export class Graphics {
  /** @returns {Graphics} with a context that is always lost if the browser lacks WebGL 2 */
  static create() {
    const canvas = document.createElement('canvas');
    const gl = canvas.getContext('webgl2', {
      antialias: true,
      alpha: false,
      stencil: false,
      powerPreference: 'high-performance',
    });
    return gl ? new Graphics(canvas, gl) : noGraphics;
  }

  /** @param {HTMLCanvasElement} canvas @param {WebGL2RenderingContext} gl */
  constructor(canvas, gl) {
    this.canvas = canvas;
    this.gl = gl;
    /** @type {(() => void)[]} Called after a lost context was restored. */
    this.listeners = [];
    canvas.addEventListener('webglcontextlost', (event) => {
      event.preventDefault(); // otherwise the browser would not restore the context
      showNote('note', word('graphicsLost'));
    });
    canvas.addEventListener('webglcontextrestored', () => {
      if (byId('note').textContent === word('graphicsLost')) showNote('note', '');
      this.objects = objectsOf(gl);
      for (const listener of this.listeners) listener();
    });
    this.objects = objectsOf(gl);
  }

  /** The pass that draws a body. @param {Core} core @param {Surface} surface @param {any} theme */
  body(core, surface, theme) {
    const { objects } = this;
    const known = objects.bodies.find((body) => body.surface === surface && body.theme === theme);
    const others = objects.bodies.filter((body) => body !== known);
    while (!known && others.length >= mostBodies) others.shift()?.pass.free();
    const body = known ?? { surface, theme, pass: new BodyPass(this.gl, core, surface, theme.materials) };
    objects.bodies = [...others, body];
    return body.pass;
  }

  /** Places the stars, which are at rest in space. @param {import("../core/pictures.js").Pictures} pictures @param {number} count */
  placeStars(pictures, count) {
    if (this.objects.starCount === count) return;
    this.objects.stars.place(pictures.stars(count));
    this.objects.starCount = count;
  }

  /** Makes room for a picture of this size. @param {number} width @param {number} height in pixels */
  begin(width, height) {
    const { canvas } = this;
    if (width > canvas.width) canvas.width = width;
    if (height > canvas.height) canvas.height = height;
  }

  /** Copies the picture to a canvas of its size. @param {CanvasRenderingContext2D} context */
  copyTo(context) {
    const { width, height } = context.canvas;
    context.drawImage(this.canvas, 0, this.canvas.height - height, width, height, 0, 0, width, height);
  }

  /** Reads the picture. @param {number} width @param {number} height in pixels */
  read(width, height) {
    const { gl } = this,
      pixels = new Uint8Array(4 * width * height);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    return pixels;
  }
}

/** Replaces the context in a browser without WebGL 2: views keep their stills, as if the context were lost. */
export const noGraphics = /** @type {Graphics} */ (
  /** @type {unknown} */ ({ gl: { isContextLost: () => true }, listeners: [] })
);
