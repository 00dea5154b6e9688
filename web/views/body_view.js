// The rotating body, or two of them, side by side or one as a ghost over the other, seen by a camera
// that may turn with a frame.
import { BodyPass } from '../picture/body_pass.js';
import { Ground } from '../picture/ground.js';
import { Stars } from '../picture/stars.js';
import { CanvasView } from './canvas_view.js';

/** @import { MotionModel } from '../app/motion_model.js' */
/** @import { FrameName } from '../app/types' */
/** @import { Camera, Samples, Settings } from '../core/types' */

/**
 * The contents of the view.
 * @typedef {object} BodyPicture
 * @property {MotionModel} model
 * @property {Samples[]} instants One, or two to compare, each with its trail, which ends at the present time.
 * @property {boolean} ghost Whether the second is a ghost over the first.
 * @property {Settings} settings
 */

const ghostOpacity = 0.42;

export class BodyView extends CanvasView {
  /**
   * @param {HTMLElement} box @param {() => void} changed
   * @param {import("../core/core.js").Core} core @param {import("../core/pictures.js").Pictures} pictures
   * @param {any} lens The scene's [camera]: azimuth, elevation, distance, field_of_view.
   */
  constructor(box, changed, core, pictures, lens) {
    super(box, changed);
    this.core = core;
    this.pictures = pictures;
    this.home = { azimuth: lens.azimuth, elevation: lens.elevation };
    this.starsFor = '';
    this.#prepare();
  }

  restore() {
    super.restore();
    this.#prepare();
  }

  #prepare() {
    const { gl } = this;
    this.ground = new Ground(gl);
    this.stars = new Stars(gl);
    this.starsFor = '';
    this.body = null;
    if (this.surface && this.theme) this.setBody(this.surface, this.theme);
  }

  /** @param {import("../app/types").Surface} surface @param {any} theme */
  setBody(surface, theme) {
    if (this.body && this.surface === surface && this.theme === theme) return;
    this.surface = surface;
    this.theme = theme;
    this.body?.free();
    this.body = new BodyPass(this.gl, this.core, surface, theme.materials);
  }

  /** @param {BodyPicture} picture */
  draw(picture) {
    const { gl, canvas } = this;
    if (!this.surface || !this.theme || gl.isContextLost()) return;
    const count = picture.instants.length > 1 && !picture.ghost ? 2 : 1;
    let names = 0;
    for (let i = 0; i < count; ++i) {
      const left = Math.round((i * canvas.width) / count),
        width = Math.round(((i + 1) * canvas.width) / count) - left;
      const settings = { ...this.sized(picture.settings), width };
      if (hasStars(this.theme, settings)) this.#placeStars(picture.model, settings);
      const contents = this.pictures.body(picture.model.motion, settings, this.viewpoint, picture.instants[i]);
      this.#drawPane(picture, i, contents, { left, width, inner: [i > 0 ? 1 : 0, i < count - 1 ? 1 : 0, 0, 0] });
      names = this.showNames(contents.labels, { left: i / count, width: 1 / count }, names);
    }
    this.hideNames(names);
  }

  /** Places the theme's stars, which are at rest in space, as the scene's camera sees them. @param {MotionModel} model @param {Settings} settings */
  #placeStars({ motion }, settings) {
    const { width, height, show, frame, radius } = settings,
      key = JSON.stringify([width, height, show, frame, radius, motion.omega, motion.inertia, motion.interior]);
    if (this.starsFor === key) return;
    this.stars?.place(this.pictures.stars(motion, settings, this.theme.backdrop.stars));
    this.starsFor = key;
  }

  /**
   * @param {BodyPicture} picture @param {number} index Of the motion.
   * @param {import("../core/types").Contents} contents
   * @param {{left: number, width: number, inner: number[]}} pane
   */
  #drawPane({ instants, settings, ghost }, index, contents, { left, width, inner }) {
    const { gl, canvas, body, ground, theme, pass } = this;
    if (!body || !ground) return;
    const { height } = canvas,
      { camera } = contents,
      X = lastAttitude(instants[index]);
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
    if (hasStars(theme, settings)) this.stars?.draw(camera, height);
    body.draw(camera, X, { width, height });
    pass.drawGhosts(contents);
    pass.drawOpaque(contents);
    if (ghost && instants[1])
      body.drawGhost(camera, lastAttitude(instants[1]), { width, height }, ghostOpacity);
    pass.drawTranslucent(contents);
    gl.disable(gl.SCISSOR_TEST);
  }
}

/** @param {any} theme @param {Settings} settings */
const hasStars = (theme, settings) => theme.backdrop.stars > 0 && settings.frame === 'space';

/** The attitude at the end of a trail. @param {Samples} samples */
const lastAttitude = ({ X }) => [...X.slice(-9)];
