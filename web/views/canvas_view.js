// What the views have in common: a canvas of WebGL 2 that is as sharp as the display, a camera that
// can be turned and zoomed by mouse, touch, pen and keyboard, and names of things in space.
import { byId } from '../app/dom.js';
import { clamp } from '../math/linear.js';
import { DrawListPass } from '../picture/draw_list_pass.js';
import { word } from '../words/words.js';
import { makeTurnable, turnByKey } from './turning.js';

/** @import { Label, Viewpoint } from '../core/types' */

/** @param {number[]} color sRGB, 0 to 255 */
export const css = (color) => `rgb(${color.map(Math.round).join(' ')})`;

/** Pixels of what is a point on an ordinary screen; more where text is larger. */
export const pixelsOfUnit = () =>
  (devicePixelRatio * parseFloat(getComputedStyle(document.documentElement).fontSize)) / 15;

const mostElevation = Math.PI / 2 - 0.001,
  gapOfName = 13; // points from the end of a thing to the middle of its name

/** How many canvases have lost their graphics. */
let canvasesLost = 0;

export class CanvasView {
  /**
   * @param {HTMLElement} box Its first canvas is drawn to; names are added beside it.
   * @param {() => void} changed Is called when the view has to be drawn anew.
   */
  constructor(box, changed) {
    this.box = box;
    this.changed = changed;
    this.canvas = /** @type {HTMLCanvasElement} */ (box.querySelector('canvas'));
    const gl = this.canvas.getContext('webgl2', {
      antialias: true,
      alpha: false,
      stencil: false,
      powerPreference: 'high-performance',
    });
    if (!gl) throw new Error('no WebGL 2');
    this.gl = gl;
    this.pass = new DrawListPass(gl);
    this.names = document.createElement('div');
    this.names.className = 'names';
    this.names.ariaHidden = 'true';
    box.append(this.names);
    this.view = { azimuth: 0, elevation: 0, zoom: 1 };
    this.home = { azimuth: 0, elevation: 0 };
    makeTurnable(this);
    new ResizeObserver((entries) => this.#resize(entries[0])).observe(this.canvas);
    this.canvas.addEventListener('webglcontextlost', (event) => {
      event.preventDefault(); // or the browser would not restore it
      ++canvasesLost;
      byId('note').textContent = word('graphicsLost');
      byId('note').hidden = false;
    });
    this.canvas.addEventListener('webglcontextrestored', () => {
      const note = byId('note');
      if (--canvasesLost === 0 && note.textContent === word('graphicsLost')) note.hidden = true;
      this.restore();
      this.changed();
    });
  }

  /** Makes what a lost context took. */
  restore() {
    this.pass = new DrawListPass(this.gl);
  }

  /**
   * Returns what a moving pointer does instead of turning the view, or null.
   * @param {PointerEvent} _event @returns {((event: PointerEvent) => void) | null}
   */
  grab(_event) {
    return null;
  }

  /** Does what a key means to the view. @param {KeyboardEvent} event @returns {boolean} whether it means anything */
  key(event) {
    return turnByKey(this, event);
  }

  /** @param {ResizeObserverEntry} entry */
  #resize(entry) {
    const device = entry.devicePixelContentBoxSize?.[0];
    // The browser knows to which whole pixels the box is rounded, but not where a display is emulated.
    const pixels = (/** @type {number} */ points, /** @type {number | undefined} */ known) =>
      known && Math.abs(known - points * devicePixelRatio) <= 1
        ? known
        : Math.round(points * devicePixelRatio);
    const width = pixels(entry.contentRect.width, device?.inlineSize),
      height = pixels(entry.contentRect.height, device?.blockSize);
    if (width === this.canvas.width && height === this.canvas.height) return;
    this.canvas.width = Math.max(1, width);
    this.canvas.height = Math.max(1, height);
    this.changed();
  }

  get aspect() {
    return this.canvas.width / Math.max(1, this.canvas.height);
  }

  /** The settings for the canvas as it is. @param {import("../core/types").Settings} settings */
  sized(settings) {
    const { width, height } = this.canvas;
    return { ...settings, width, height, thinnest: pixelsOfUnit() };
  }

  /** Fills the canvas with a colour. @param {number[]} color sRGB, 0 to 255 */
  clear([red, green, blue]) {
    const { gl, canvas } = this;
    gl.viewport(0, 0, canvas.width, canvas.height);
    gl.clearColor(red / 255, green / 255, blue / 255, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  }

  /** @returns {Viewpoint} */
  get viewpoint() {
    return {
      azimuth: this.home.azimuth + this.view.azimuth,
      elevation: clamp(this.home.elevation + this.view.elevation, -mostElevation, mostElevation),
      zoom: this.view.zoom,
    };
  }

  /** Turns the view, angles in rad. @param {number} azimuth @param {number} elevation */
  turn(azimuth, elevation) {
    this.view.azimuth += azimuth;
    this.view.elevation = clamp(
      this.view.elevation + elevation,
      -mostElevation - this.home.elevation,
      mostElevation - this.home.elevation,
    );
    this.moved();
  }

  /** @param {number} factor */
  zoom(factor) {
    this.view.zoom = clamp(this.view.zoom * factor, 0.25, 8);
    this.moved();
  }

  moved() {
    this.changed();
  }

  resetView() {
    this.view = { azimuth: 0, elevation: 0, zoom: 1 };
    this.moved();
  }

  /** The place of a pointer in the picture: -1 to 1 across and up. @param {PointerEvent} event */
  placeOf(event) {
    const box = this.canvas.getBoundingClientRect();
    return [
      (2 * (event.clientX - box.left)) / box.width - 1,
      1 - (2 * (event.clientY - box.top)) / box.height,
    ];
  }

  /**
   * Shows names beside what they name.
   * @param {Label[]} labels @param {{left: number, width: number}} [pane] in shares of the canvas
   * @param {number} [first] How many names there are already.
   * @returns {number} How many names there are now.
   */
  showNames(labels, pane = { left: 0, width: 1 }, first = 0) {
    const { clientWidth, clientHeight } = this.canvas,
      pointsOfPixel = clientWidth / this.canvas.width;
    let shown = first;
    for (const { text, anchor, away, color } of labels) {
      const span = this.#name(shown++);
      span.textContent = text;
      span.style.color = css(color);
      const [x, y] = anchor.map((place, i) => pointsOfPixel * place + gapOfName * away[i]);
      const left = clientWidth * pane.left + clamp(x, 10, clientWidth * pane.width - 10);
      const top = clamp(y, 12, clientHeight - 12);
      span.style.transform = `translate(${left.toFixed(1)}px, ${top.toFixed(1)}px) translate(-50%, -50%)`;
    }
    return shown;
  }

  /** Hides the names from that one on. @param {number} shown */
  hideNames(shown) {
    for (let i = shown; i < this.names.children.length; ++i)
      /** @type {HTMLElement} */ (this.names.children[i]).textContent = '';
  }

  /** @param {number} i @returns {HTMLElement} */
  #name(i) {
    while (this.names.children.length <= i) this.names.append(document.createElement('span'));
    return /** @type {HTMLElement} */ (this.names.children[i]);
  }
}
