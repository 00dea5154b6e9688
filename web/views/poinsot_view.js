// Poinsot's construction: the inertia ellipsoid rolls without slipping on the invariable plane.
import { DrawListPass } from '../picture/draw_list_pass.js';
import { CanvasView } from './canvas_view.js';

/** @typedef {import("../app/motion_model.js").MotionModel} MotionModel */
/** @typedef {import("../core/core.js").Samples} Samples */

export class PoinsotView extends CanvasView {
  /** @param {HTMLElement} box @param {() => void} changed @param {import("../core/pictures.js").Pictures} pictures */
  constructor(box, changed, pictures) {
    super(box, changed);
    this.pictures = pictures;
    this.hasHome = false; // it is the same for all motions
    this.restore();
  }

  restore() {
    this.pass = new DrawListPass(this.gl);
  }

  /** @param {{model: MotionModel, settings: import("../core/pictures.js").Settings, instant: Samples, colors: any}} picture */
  draw({ model, settings, instant, colors }) {
    const { gl, pass } = this;
    if (gl.isContextLost() || !pass) return;
    const own = this.sized(settings);
    if (!this.hasHome) this.home = this.pictures.home('poinsot', model.motion, own);
    this.hasHome = true;
    this.clear(colors.panel);
    const contents = this.pictures.poinsot(model.motion, own, this.viewpoint, instant);
    pass.draw(contents);
    this.hideNames(this.showNames(contents.labels));
  }
}
