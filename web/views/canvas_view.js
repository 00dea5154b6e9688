// Base of the views: a canvas at the display's resolution, drawn only while it is on the screen, a camera that
// can be turned and zoomed by mouse, touch, pen and keyboard, and labels of objects in space.
import { clamp } from '../math/linear.js';
import { drawStill, findStill } from './stills.js';
import { makeTurnable, turnByKey } from './turning.js';

/** @import { Label, Viewpoint } from '../core/types' */
/** @import { Graphics } from '../picture/graphics.js' */

/** @param {number[]} color sRGB, 0 to 255 */
export const css = (color) => `rgb(${color.map(Math.round).join(' ')})`;

/** Pixels per point: 1 on an ordinary screen, more if text is larger. */
export const pixelsOfUnit = () =>
  (devicePixelRatio * parseFloat(getComputedStyle(document.documentElement).fontSize)) / 15;

const mostElevation = Math.PI / 2 - 0.001,
  gapOfName = 13; // points from the end of an object to the middle of its name

export class CanvasView {
  /**
   * @param {HTMLElement} box The view draws to its first canvas and adds names beside it.
   * @param {Graphics} graphics
   * @param {() => void} changed Called when the view must be drawn again.
   */
  constructor(box, graphics, changed) {
    this.box = box;
    this.graphics = graphics;
    this.changed = changed;
    this.canvas = /** @type {HTMLCanvasElement} */ (box.querySelector('canvas'));
    this.context = /** @type {CanvasRenderingContext2D} */ (this.canvas.getContext('2d'));
    this.gl = graphics.gl;
    this.still = findStill(box.dataset);
    this.wasDrawn = false;
    this.isVisible = false;
    /** Whether the wheel zooms the focused view; otherwise it scrolls the page unless Ctrl is pressed. */
    this.wheelZooms = true;
    this.names = document.createElement('div');
    this.names.className = 'names';
    this.names.ariaHidden = 'true';
    box.append(this.names);
    this.view = { azimuth: 0, elevation: 0, zoom: 1 };
    this.home = { azimuth: 0, elevation: 0 };
    makeTurnable(this);
    new ResizeObserver((entries) => this.#resize(entries[0])).observe(this.canvas);
    new IntersectionObserver((entries) => {
      this.isVisible = entries[entries.length - 1].isIntersecting;
      if (this.isVisible) this.changed();
    }).observe(box);
    graphics.listeners.push(() => this.changed());
  }

  /** Whether drawing would be seen. */
  get isDrawn() {
    return this.isVisible && !this.gl.isContextLost();
  }

  /**
   * Returns a function to call with a moving pointer instead of turning the view, or null.
   * @param {PointerEvent} _event @returns {((event: PointerEvent) => void) | null}
   */
  grab(_event) {
    return null;
  }

  /** Handles a key. @param {KeyboardEvent} event @returns {boolean} whether the view uses the key */
  key(event) {
    return turnByKey(this, event);
  }

  /** @param {ResizeObserverEntry} entry */
  #resize(entry) {
    const device = entry.devicePixelContentBoxSize?.[0];
    // The browser reports the box in whole pixels, except on an emulated display.
    const pixels = (/** @type {number} */ points, /** @type {number | undefined} */ known) =>
      known && Math.abs(known - points * devicePixelRatio) <= 1
        ? known
        : Math.round(points * devicePixelRatio);
    const width = pixels(entry.contentRect.width, device?.inlineSize),
      height = pixels(entry.contentRect.height, device?.blockSize);
    if (width === this.canvas.width && height === this.canvas.height) return;
    this.canvas.width = Math.max(1, width);
    this.canvas.height = Math.max(1, height);
    this.#drawStill();
    this.changed();
  }

  /** Shows the view's still in the resized canvas until the view is drawn. */
  #drawStill() {
    if (this.wasDrawn || !this.still) return;
    const { image } = this.still;
    if (!image.complete) image.addEventListener('load', () => this.#drawStill(), { once: true });
    else if (image.naturalWidth > 0) drawStill(this.context, this.still);
  }

  /** Copies the picture that the view has drawn to its canvas. */
  show() {
    this.wasDrawn = true;
    this.graphics.copyTo(this.context);
  }

  /** The settings for the present size of the canvas. @param {import("../core/types").Settings} settings */
  sized(settings) {
    const { width, height } = this.canvas;
    return { ...settings, width, height, thinnest: pixelsOfUnit() };
  }

  /** Begins a picture of the canvas' size, filled with a colour. @param {number[]} color sRGB, 0 to 255 */
  clear([red, green, blue]) {
    const { gl, canvas } = this;
    this.graphics.begin(canvas.width, canvas.height);
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
   * Shows names beside their objects.
   * @param {Label[]} labels @param {{left: number, width: number}} [pane] in shares of the canvas
   * @param {number} [first] Number of names that are already shown.
   * @returns {number} Number of names that are shown now.
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

  /** Hides the names from index `shown` on. @param {number} shown */
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
