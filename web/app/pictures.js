// The views: updates their contents, and handles turning and dragging.
import { Pictures as CorePictures } from '../core/pictures.js';
import { BodyView } from '../views/body_view.js';
import { InsetView } from '../views/inset_view.js';
import { SphereView } from '../views/sphere_view.js';
import { pngOf } from '../picture/png.js';
import { boxSurface } from '../picture/surface.js';
import { byId } from './dom.js';
import { trailTimes } from './motion_model.js';
import { framesPerSecond } from './player.js';
import { hasMeaning, isRigid } from './state.js';

/** @import { MotionModel } from './motion_model.js' */
/** @import { State } from './types' */

const pointsOfHerpolhode = 1200,
  widestTurn = 0.35; // rad between two points of the herpolhode

export class Pictures {
  /**
   * @param {import('./state.js').Store} store @param {import('./types').PageData} data
   * @param {import('./player.js').Player} player @param {import('./runs.js').Runs} runs
   * @param {import('../core/core.js').Core} core
   */
  constructor(store, data, player, runs, core) {
    this.store = store;
    this.data = data;
    this.player = player;
    this.runs = runs;
    /** @type {{moments: number[], surface: import('./types').Surface} | null} */
    this.box = null;
    const invalidate = () => player.invalidate();
    const shown = new CorePictures(core);
    this.bodyView = new BodyView(byId('body'), invalidate, core, shown, data.scene.camera);
    this.insets = shown.names.insets.map((name) =>
      name === 'sphere'
        ? new SphereView(byId(name), invalidate, shown, (omega) => store.set({ omega }))
        : new InsetView(byId(name), invalidate, shown),
    );
    this.bodyView.moved = () => {
      const { azimuth, elevation, zoom } = this.bodyView.view;
      store.set({ view: [azimuth, elevation, zoom].map((x) => Number(x.toFixed(4))) });
    };
    for (const view of [this.bodyView, ...this.insets]) {
      view.canvas.addEventListener('keydown', (event) => this.#key(view, event));
    }
  }

  /** @param {import('../views/canvas_view.js').CanvasView} view @param {KeyboardEvent} event */
  #key(view, event) {
    if (event.key === ' ') this.player.play(!this.player.playing);
    else if (!view.key(event)) return;
    event.preventDefault();
  }

  /** Moves the camera of the body's view to the viewpoint of the state. */
  follow() {
    const [azimuth, elevation, zoom] = this.store.state.view;
    this.bodyView.view = { azimuth, elevation, zoom };
  }

  /** The trail of the exact motion, or of a method, that ends at t. @param {MotionModel} model @param {{samples: (times: number[]) => import("../core/types").Samples}} source */
  #trail(model, source) {
    const { t } = this.store.state;
    return source.samples(trailTimes(t, model.trailLength, model.facts.rate));
  }

  /** The settings of the views, beside the motion. @param {MotionModel} model @param {string} theme */
  #settings(model, theme) {
    const { state } = this.store,
      { scene } = this.data,
      [trailX, trailY, trailZ] = this.#surface.trail_point,
      { azimuth, elevation, distance, field_of_view: fieldOfView } = scene.camera;
    // The part of the herpolhode around t, with as many turns as are distinguishable.
    const span = Math.min(
      model.facts.longest,
      scene.motion.duration,
      (pointsOfHerpolhode * widestTurn) / Math.max(model.facts.rate, 1e-300),
    );
    const curveBegin = isRigid(state) ? span * Math.floor(state.t / span) : 0;
    return {
      width: 1,
      height: 1,
      thinnest: 1,
      theme,
      frame: state.frame,
      show: state.show.filter((feature) => hasMeaning(feature, state, this.data)),
      azimuth,
      elevation,
      distance,
      fieldOfView,
      interval: this.player.playing ? state.speed / framesPerSecond : 0,
      radius: this.#surface.radius,
      trailLength: model.trailLength,
      trailX,
      trailY,
      trailZ,
      curveBegin,
      curveEnd: curveBegin + span,
    };
  }

  /** The contents of the body view. @param {MotionModel} model @param {string} theme */
  #bodyPicture(model, theme) {
    const sources = this.runs.runners.length ? this.runs.runners : [model.motion];
    return {
      model,
      instants: sources.map((source) => this.#trail(model, source)),
      ghost: this.store.state.compare === 'ghost',
      settings: this.#settings(model, theme),
    };
  }

  /** The surface of the chosen body. */
  get #surface() {
    const { moments } = this.store.state;
    if (!moments) return this.data.surface;
    if (this.box?.moments !== moments) this.box = { moments, surface: boxSurface(this.bodyView.core, moments) };
    return this.box.surface;
  }

  /**
   * Draws the views.
   * @param {MotionModel} model @param {string} name of the theme @param {any} theme
   * @returns {number[]} the attitude shown
   */
  draw(model, name, theme) {
    const picture = this.#bodyPicture(model, name);
    this.bodyView.setBody(this.#surface, theme);
    this.bodyView.draw(picture);
    for (const view of this.insets) {
      const figure = /** @type {HTMLElement} */ (view.box.parentElement);
      figure.hidden = !hasMeaning(view.box.id, this.store.state, this.data);
      if (!figure.hidden) view.draw({ ...picture, colors: theme.overlay });
    }
    return [...picture.instants[0].X.slice(-9)];
  }

  /**
   * The body as a PNG of any size.
   * @param {MotionModel} model @param {string} name of the theme @param {any} theme
   * @param {number} width @param {number} height in pixels
   * @returns {Promise<Blob>}
   */
  png(model, name, theme, width, height) {
    const { gl, canvas } = this.bodyView,
      size = [canvas.width, canvas.height],
      pixels = new Uint8Array(4 * width * height);
    [canvas.width, canvas.height] = [width, height];
    while (this.runs.advance(this.store.state.t));
    this.bodyView.setBody(this.#surface, theme);
    this.bodyView.draw(this.#bodyPicture(model, name));
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    [canvas.width, canvas.height] = size;
    this.player.invalidate();
    return pngOf(pixels, width, height);
  }
}
