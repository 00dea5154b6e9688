// The views: updates their contents, and handles turning and dragging.
import { Pictures as CorePictures } from '../core/pictures.js';
import { BodyView } from '../views/body_view.js';
import { InsetView } from '../views/inset_view.js';
import { SphereView } from '../views/sphere_view.js';
import { pngOf } from '../picture/png.js';
import { boxSurface } from '../picture/surface.js';
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
   * @param {import('../core/core.js').Core} core @param {import('../picture/graphics.js').Graphics} graphics
   * @param {Record<string, HTMLElement>} boxes Of the body's view and of the insets, by name.
   */
  constructor(store, data, player, runs, core, graphics, boxes) {
    this.store = store;
    this.data = data;
    this.player = player;
    this.runs = runs;
    /** @type {{moments: number[], surface: import('./types').Surface} | null} */
    this.box = null;
    /** Features that stand out from the others. @type {readonly string[]} */
    this.stress = [];
    const invalidate = () => player.invalidate();
    const shown = new CorePictures(core);
    this.bodyView = new BodyView(boxes.body, graphics, invalidate, core, shown, data.scene.camera);
    const names = shown.names.insets.filter((name) => boxes[name]);
    this.insets = names.map((name) =>
      name === 'sphere'
        ? new SphereView(boxes[name], graphics, invalidate, shown, (omega) => store.set({ omega }))
        : new InsetView(name, boxes[name], graphics, invalidate, shown),
    );
    this.bodyView.moved = () => {
      const { azimuth, elevation, zoom } = this.bodyView.view;
      store.set({ view: [azimuth, elevation, zoom].map((x) => Number(x.toFixed(4))) });
    };
    this.views = [this.bodyView, ...this.insets];
    for (const view of this.views) {
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
      stress: this.stress,
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

  /** The motions to show: each, or each as the compared methods compute it. @param {MotionModel[]} models @param {string} theme */
  #panes(models, theme) {
    const { runners } = this.runs;
    return models.flatMap((model) => {
      const settings = this.#settings(model, theme),
        sources = runners.length ? runners : [model.motion];
      return sources.map((source) => ({ model, settings, instant: this.#trail(model, source) }));
    });
  }

  /** The contents of the body view. @param {import('../views/body_view.js').Pane[]} panes @param {any} theme */
  #bodyPicture(panes, theme) {
    const isGhost = this.store.state.compare === 'ghost';
    return {
      panes: isGhost ? panes.slice(0, 1) : panes,
      ghost: isGhost ? panes[1].instant : null,
      surface: this.#surface,
      theme,
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
   * @param {MotionModel[]} models @param {string} name of the theme @param {any} theme
   * @returns {number[]} the attitude of the first
   */
  draw(models, name, theme) {
    const panes = this.#panes(models, name),
      [{ model, settings, instant }] = panes;
    this.bodyView.draw(this.#bodyPicture(panes, theme));
    const instants = panes.map((pane) => pane.instant);
    for (const view of this.insets) {
      const figure = /** @type {HTMLElement} */ (view.box.parentElement);
      figure.hidden = !hasMeaning(view.box.id, this.store.state, this.data);
      if (!figure.hidden) view.draw({ model, settings, instants, colors: theme.overlay });
    }
    return [...instant.X.slice(-9)];
  }

  /**
   * The body as a PNG of any size.
   * @param {MotionModel[]} models @param {string} name of the theme @param {any} theme
   * @param {number} width @param {number} height in pixels
   * @returns {Promise<Blob>}
   */
  png(models, name, theme, width, height) {
    const { bodyView } = this,
      { graphics } = bodyView,
      { canvas } = graphics,
      size = [canvas.width, canvas.height];
    while (this.runs.advance(this.store.state.t));
    bodyView.paint(this.#bodyPicture(this.#panes(models, name), theme), width, height);
    const pixels = graphics.read(width, height);
    [canvas.width, canvas.height] = size; // otherwise a large picture's memory would be kept
    return pngOf(pixels, width, height);
  }
}
