// The rotating body, or several of them side by side, or one as a ghost over another, seen by a camera that
// may turn with a frame.
import { CanvasView, pixelsOfUnit } from './canvas_view.js';

/** @import { MotionModel } from '../app/motion_model.js' */
/** @import { Samples, Settings } from '../core/types' */

/** A motion with its trail, which ends at the present time. @typedef {{model: MotionModel, settings: Settings, instant: Samples}} Pane */
/**
 * The contents of the view.
 * @typedef {object} BodyPicture
 * @property {Pane[]} panes Side by side.
 * @property {Samples | null} ghost Drawn over the first.
 * @property {import("../app/types").Surface} surface Of the body.
 * @property {any} theme
 */

const ghostOpacity = 0.42;

export class BodyView extends CanvasView {
  /**
   * @param {HTMLElement} box @param {import("../picture/graphics.js").Graphics} graphics @param {() => void} changed
   * @param {import("../core/core.js").Core} core @param {import("../core/pictures.js").Pictures} pictures
   * @param {any} lens The scene's [camera]: azimuth, elevation, distance, field_of_view.
   */
  constructor(box, graphics, changed, core, pictures, lens) {
    super(box, graphics, changed);
    this.core = core;
    this.pictures = pictures;
    this.home = { azimuth: lens.azimuth, elevation: lens.elevation };
  }

  /** @param {BodyPicture} picture */
  draw(picture) {
    if (!this.isDrawn) return;
    const { width, height } = this.canvas;
    let names = 0;
    this.paint(picture, width, height).forEach((labels, i, { length }) => {
      names = this.showNames(labels, { left: i / length, width: 1 / length }, names);
    });
    this.hideNames(names);
    this.show();
  }

  /**
   * Draws a picture of any size into the shared context.
   * @param {BodyPicture} picture @param {number} width @param {number} height in pixels
   * @returns {import("../core/types").Label[][]} the labels of each pane
   */
  paint(picture, width, height) {
    const { theme, panes } = picture;
    this.graphics.begin(width, height);
    return panes.map(({ model, settings, instant }, i) => {
      const left = Math.round((i * width) / panes.length),
        end = Math.round(((i + 1) * width) / panes.length);
      const own = { ...settings, width: end - left, height, thinnest: pixelsOfUnit() };
      if (hasStars(theme, own)) this.graphics.placeStars(this.pictures, theme.backdrop.stars);
      const contents = this.pictures.body(model.motion, own, this.viewpoint, instant);
      this.#drawPane(picture, own, instant, contents, {
        left,
        inner: [i > 0 ? 1 : 0, i < panes.length - 1 ? 1 : 0, 0, 0],
      });
      return contents.labels;
    });
  }

  /**
   * @param {BodyPicture} picture @param {Settings} settings @param {Samples} instant
   * @param {import("../core/types").Contents} contents
   * @param {{left: number, inner: number[]}} place
   */
  #drawPane({ surface, theme, ghost }, settings, instant, contents, { left, inner }) {
    const { gl } = this,
      { ground, lists, stars } = this.graphics.objects,
      { width, height } = settings,
      { camera } = contents,
      body = this.graphics.body(this.core, surface, theme),
      X = lastAttitude(instant);
    const hasFloor = settings.show.includes('floor') && settings.frame === 'space';
    if (hasFloor && theme.floor && camera.attitude[7] > 0) ground.reflect(body, camera, X, width / height);
    gl.viewport(left, 0, width, height);
    gl.scissor(left, 0, width, height);
    gl.enable(gl.SCISSOR_TEST);
    gl.clear(gl.DEPTH_BUFFER_BIT);
    ground.draw(theme, camera, X, body, {
      width,
      height,
      inner,
      floor: hasFloor,
      turned: this.view.azimuth !== 0 || this.view.elevation !== 0,
    });
    if (hasStars(theme, settings)) stars.draw(camera, height);
    body.draw(camera, X, { width, height });
    lists.drawGhosts(contents);
    lists.drawOpaque(contents);
    if (ghost) body.drawGhost(camera, lastAttitude(ghost), { width, height }, ghostOpacity);
    lists.drawTranslucent(contents);
    gl.disable(gl.SCISSOR_TEST);
  }
}

/** @param {any} theme @param {Settings} settings */
const hasStars = (theme, settings) => theme.backdrop.stars > 0 && settings.frame === 'space';

/** The attitude at the end of a trail. @param {Samples} samples */
const lastAttitude = ({ X }) => [...X.slice(-9)];
