// The rotating body, or two of them side by side or one as a ghost over the other, seen by a camera
// that may go along with a turning frame: src/picture/views/body_view.cpp.
import { product, times, transposed } from '../math/linear.js';
import { carried, directionOf, fitted, frameSphere } from '../math/camera.js';
import { BodyPass } from '../picture/body_pass.js';
import { DrawList } from '../picture/draw_list.js';
import { DrawListPass } from '../picture/draw_list_pass.js';
import { addFixedStars } from '../picture/fixed_stars.js';
import { Ground } from '../picture/ground.js';
import { Stars } from '../picture/stars.js';
import { BodyOverlay } from './body_overlay.js';
import { CanvasView } from './canvas_view.js';

/** @typedef {import("../app/motion_model.js").MotionModel} MotionModel */
/** @typedef {import("../app/state.js").FrameName} FrameName */
/** @typedef {import("../core/core.js").Sample} Sample */
/** @typedef {import("../math/camera.js").Camera} Camera */
/** One motion at one time: its trail, oldest first, ends with the sample. @typedef {{sample: Sample, trail: Sample[]}} Instant */

/**
 * What the view shows.
 * @typedef {object} BodyPicture
 * @property {MotionModel} model
 * @property {Instant[]} instants One, or two to compare.
 * @property {boolean} ghost Whether the second is a ghost over the first.
 * @property {FrameName} frame
 * @property {number} halfOpen Half the time for which the shutter is open, s of the motion.
 * @property {import("./body_overlay.js").Shown} shown
 */

const ghostOpacity = 0.42;

export class BodyView extends CanvasView {
  /**
   * @param {HTMLElement} box @param {() => void} changed
   * @param {any} lens The scene's [camera]: azimuth, elevation, distance, field_of_view.
   */
  constructor(box, changed, lens) {
    super(box, changed);
    this.lens = lens;
    this.home = { azimuth: lens.azimuth, elevation: lens.elevation };
    this.opaque = new DrawList();
    this.translucent = new DrawList();
    this.starsFor = '';
    /** @type {BodyOverlay | null} */
    this.overlay = null;
    /** @type {{overlay: BodyOverlay, key: string, value: import("../math/camera.js").Framing} | null} */
    this.framing = null;
    this.restore();
  }

  restore() {
    const { gl } = this;
    this.pass = new DrawListPass(gl);
    this.ground = new Ground(gl);
    this.stars = new Stars(gl);
    this.starsFor = '';
    this.body = null;
    if (this.surface && this.theme) this.setBody(this.surface, this.theme);
  }

  /** @param {import("../picture/surface.js").Surface} surface @param {any} theme */
  setBody(surface, theme) {
    if (this.body && this.surface === surface && this.theme === theme) return;
    this.surface = surface;
    this.theme = theme;
    this.body?.free();
    this.body = new BodyPass(this.gl, surface, theme.materials);
    this.overlay = null;
  }

  /** @param {BodyPicture} picture */
  #framing({ model, instants, frame, shown, ghost }) {
    const { overlay } = this;
    if (!overlay) throw new Error('no body');
    const panes = instants.length > 1 && !ghost ? 2 : 1;
    const aspect = this.aspect / panes;
    const key = `${aspect} ${frame} ${shown.axes} ${shown.momentum} ${shown.omega} ${shown.plane}`;
    if (this.framing?.overlay === overlay && this.framing.key === key) return this.framing.value;
    const framing = {
      fieldOfView: this.lens.field_of_view,
      aspect,
      radius: overlay.boundingRadius(shown),
      distance: 1,
      centre: [0, 0],
    };
    const points = overlay.extent(shown).flatMap((point) => pointInFrame(model, frame, point));
    const value = fitted(framing, [directionOf(this.lens.azimuth, this.lens.elevation)], points);
    value.distance *= this.lens.distance;
    value.centre = value.centre.map((x) => x / this.lens.distance);
    this.framing = { overlay, key, value };
    return value;
  }

  /** @param {BodyPicture} picture @returns {Camera} In the frame's coordinates. */
  camera(picture) {
    const framing = this.#framing(picture);
    const { zoom } = this.view;
    return frameSphere(
      { ...framing, distance: framing.distance / zoom, centre: framing.centre.map((x) => x * zoom) },
      this.direction(),
    );
  }

  /** @param {BodyPicture} picture */
  draw(picture) {
    const { gl, canvas, surface, theme } = this;
    if (!surface || !theme || gl.isContextLost()) return;
    if (
      !this.overlay ||
      this.overlay.model !== picture.model ||
      this.overlay.surface !== surface ||
      this.overlay.colors !== theme.overlay
    ) {
      this.overlay = new BodyOverlay(picture.model, surface, theme.overlay);
    }
    const beside = picture.instants.length > 1 && !picture.ghost;
    const camera = this.camera(picture);
    let names = 0;
    const count = beside ? 2 : 1;
    for (let i = 0; i < count; ++i) {
      const left = Math.round((i * canvas.width) / count),
        width = Math.round(((i + 1) * canvas.width) / count) - left;
      const pane = { left, width, inner: [i > 0 ? 1 : 0, i < count - 1 ? 1 : 0, 0, 0] };
      const sample = picture.instants[i].sample;
      const seen = carried(camera, picture.model.frameAt(picture.frame, sample));
      this.#drawPane(picture, picture.instants[i], seen, pane);
      names = this.showNames(
        this.overlay.labels(picture.shown, sample),
        seen,
        { left: i / count, width: 1 / count },
        names,
      );
    }
    this.hideNames(names);
  }

  /**
   * @param {BodyPicture} picture @param {Instant} instant @param {Camera} camera
   * @param {{left: number, width: number, inner: number[]}} pane
   */
  #drawPane(picture, instant, camera, { left, width, inner }) {
    const { gl, canvas, body, ground, overlay, surface, theme, pass, opaque, translucent } = this;
    if (!body || !ground || !overlay || !surface || !pass) return;
    const { height } = canvas;
    const { X } = instant.sample;
    const hasFloor = picture.shown.floor && picture.frame === 'space';
    if (hasFloor && theme.floor && camera.attitude[7] > 0) ground.reflect(body, camera, X, width / height);
    gl.viewport(left, 0, width, height);
    gl.scissor(left, 0, width, height);
    gl.enable(gl.SCISSOR_TEST);
    gl.clear(gl.DEPTH_BUFFER_BIT);
    ground.draw(theme, camera, X, surface, {
      width,
      height,
      inner,
      floor: hasFloor,
      turned: this.view.azimuth !== 0 || this.view.elevation !== 0,
    });
    this.#drawStars(picture, camera, height);
    opaque.begin(camera, width, height);
    translucent.begin(camera, width, height);
    this.#addFixedStars(picture, instant.sample, camera, height);
    overlay.drawArrows(picture.shown, instant.sample, opaque);
    overlay.drawTranslucent(picture.shown, this.#relative(picture, instant), translucent);
    body.draw(camera, X, { width, height });
    pass.drawGhosts(opaque);
    pass.drawOpaque(opaque);
    if (picture.ghost && picture.instants[1])
      body.drawGhost(camera, picture.instants[1].sample.X, { width, height }, ghostOpacity);
    pass.drawTranslucent(translucent);
    gl.disable(gl.SCISSOR_TEST);
  }

  /** The trail as it was in the frame, which has turned on since. @param {BodyPicture} picture @param {Instant} instant */
  #relative({ model, frame }, { sample, trail }) {
    if (frame === 'space') return trail;
    const now = model.frameAt(frame, sample);
    return trail.map((earlier) => ({
      ...earlier,
      X: product(product(now, transposed(model.frameAt(frame, earlier))), earlier.X),
    }));
  }

  /** The theme's stars, which rest in space. @param {BodyPicture} picture @param {Camera} camera @param {number} height */
  #drawStars(picture, camera, height) {
    const { stars, theme } = this;
    if (!stars || !theme.backdrop.stars || picture.frame !== 'space') return;
    const framing = this.#framing(picture),
      key = JSON.stringify(framing);
    if (this.starsFor !== key) {
      const home = frameSphere(framing, directionOf(this.lens.azimuth, this.lens.elevation));
      stars.place(home, theme.backdrop.stars);
      this.starsFor = key;
    }
    stars.draw(camera, height);
  }

  /**
   * The stars that show how a frame turns.
   * @param {BodyPicture} picture @param {Sample} sample @param {Camera} camera @param {number} height
   */
  #addFixedStars({ model, frame, shown, halfOpen }, sample, camera, height) {
    if (frame === 'space' || !shown.floor) return;
    const omega = model.frameOmega(frame, sample),
      look = { color: this.theme.overlay.dim, height };
    addFixedStars(this.translucent, omega, halfOpen, camera.distance, look);
  }
}

/** Where a point of space goes in a frame, if it moves in it. @param {MotionModel} model @param {FrameName} frame @param {number[]} point */
function pointInFrame(model, frame, point) {
  if (frame === 'space') return [point];
  const span =
    model.flips && Number.isFinite(model.flips.interval) ? 2 * model.flips.interval : 8 * model.trailLength;
  const points = [];
  for (let i = 0; i <= 60; ++i) {
    const sample = model.motion.at((span * i) / 60);
    points.push(times(transposed(model.frameAt(frame, sample)), point));
  }
  return points;
}
