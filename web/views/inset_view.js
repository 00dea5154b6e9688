// A view without the body. The core computes its contents (src/picture/views).
import { CanvasView } from './canvas_view.js';

/** @import { MotionModel } from '../app/motion_model.js' */
/** @import { Samples, Settings } from '../core/types' */

/** The contents of the view: one motion, or two to compare. @typedef {{model: MotionModel, settings: Settings, instants: Samples[], colors: any}} InsetPicture */

export class InsetView extends CanvasView {
  /**
   * @param {string} name Of the inset.
   * @param {HTMLElement} box @param {import("../picture/graphics.js").Graphics} graphics @param {() => void} changed
   * @param {import("../core/pictures.js").Pictures} pictures
   */
  constructor(name, box, graphics, changed, pictures) {
    super(box, graphics, changed);
    this.name = name;
    this.pictures = pictures;
    this.facing = '';
    /** @type {{model: MotionModel, settings: Settings} | null} */
    this.shown = null;
  }

  /**
   * The settings for the direction from which a motion is seen. The direction is chosen once for each
   * body; otherwise the view would jump while the start is dragged.
   * @param {MotionModel} model @param {Settings} settings
   */
  #facing({ motion }, settings) {
    const key = motion.inertia.join();
    if (key !== this.facing) {
      this.home = this.pictures.home(this.name, motion, settings);
      this.facing = key;
    }
    return { ...settings, ...this.home };
  }

  /** @param {InsetPicture} picture */
  draw({ model, settings, instants, colors }) {
    const own = this.#facing(model, this.sized(settings));
    this.shown = { model, settings: own };
    if (!this.isDrawn) return;
    this.clear(colors.panel);
    const contents = this.pictures.inset(this.name, model.motion, own, this.viewpoint, instants);
    this.graphics.objects.lists.draw(contents);
    this.show();
    this.hideNames(this.showNames(contents.labels));
  }
}
