// The momentum in the body frame, on a sphere because its length is constant. The start of the motion
// can be dragged.
import { DrawListPass } from '../picture/draw_list_pass.js';
import { CanvasView } from './canvas_view.js';

/** @typedef {import("../app/motion_model.js").MotionModel} MotionModel */
/** @typedef {import("../core/core.js").Samples} Samples */
/** @typedef {import("../core/pictures.js").Settings} Settings */

/** What the view shows: one motion, or two to compare. @typedef {{model: MotionModel, settings: Settings, instants: Samples[], colors: any}} SpherePicture */

const startSize = 22; // points from its middle within which it is taken hold of

export class SphereView extends CanvasView {
  /** @param {HTMLElement} box @param {() => void} changed @param {import("../core/pictures.js").Pictures} pictures */
  constructor(box, changed, pictures) {
    super(box, changed);
    this.pictures = pictures;
    this.facing = '';
    /** @type {{model: MotionModel, settings: Settings} | null} */
    this.shown = null;
    this.restore();
  }

  restore() {
    this.pass = new DrawListPass(this.gl);
  }

  /**
   * The settings for the side from which a motion is seen. It is chosen once for a body: the view
   * would jump while the start is dragged.
   * @param {MotionModel} model @param {Settings} settings
   */
  #facing({ motion, principal }, settings) {
    const key = principal.axes.join() + principal.names.join();
    if (key !== this.facing) {
      this.home = this.pictures.home('sphere', motion, settings);
      this.facing = key;
    }
    return { ...settings, ...this.home };
  }

  /** @param {SpherePicture} picture */
  draw({ model, settings, instants, colors }) {
    const { gl, pass } = this;
    if (gl.isContextLost() || !pass) return;
    this.shown = { model, settings: this.#facing(model, this.sized(settings)) };
    this.colors = colors;
    this.clear(colors.panel);
    const contents = this.pictures.sphere(model.motion, this.shown.settings, this.viewpoint, instants);
    pass.draw(contents);
    this.hideNames(this.showNames(contents.labels));
  }

  /** Whether a place in the picture is at the start. @param {number[]} at -1 to 1 across and up */
  isAtStart([x, y]) {
    if (!this.shown || this.shown.model.atRest) return false;
    const { model, settings } = this.shown,
      { width, clientWidth, clientHeight } = this.canvas,
      start = this.pictures.start(model.motion, settings, this.viewpoint);
    const [across, down] = start.map((pixels) => (pixels * clientWidth) / width);
    return Math.hypot(across - ((1 + x) * clientWidth) / 2, down - ((1 - y) * clientHeight) / 2) < startSize;
  }

  /** The omega with which the motion starts at a place in the picture. @param {number[]} at */
  omegaAt(at) {
    if (!this.shown) return null;
    return this.pictures.omegaAt(this.shown.model.motion, this.shown.settings, this.viewpoint, at);
  }

  /** The omega with which it starts by angles across and up from where it does, rad. @param {number[]} way */
  omegaMoved(way) {
    if (!this.shown) return null;
    return this.pictures.omegaMoved(this.shown.model.motion, this.shown.settings, this.viewpoint, way);
  }
}
