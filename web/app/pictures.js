// What the three views show: the body, the momentum sphere and Poinsot's construction, and what can be
// done to them by hand.
import { BodyView } from '../views/body_view.js';
import { PoinsotView } from '../views/poinsot_view.js';
import { SphereView } from '../views/sphere_view.js';
import { makeTurnable, turnByKey } from '../views/turning.js';
import { pngOf } from '../picture/png.js';
import { boxSurface } from '../picture/surface.js';
import { byId } from './dom.js';
import { listed, trailTimes } from './motion_model.js';
import { framesPerSecond } from './player.js';

/** @typedef {import('./motion_model.js').MotionModel} MotionModel */
/** @typedef {import('./state.js').State} State */

const pointsOfHerpolhode = 1200,
  widestTurn = 0.35; // rad between two of them
const shutter = 0.25; // half of half the time between two frames, as in the film
const stepOfStart = 0.02; // rad by an arrow key

export class Pictures {
  /**
   * @param {import('./state.js').Store} store @param {import('./page_data.js').PageData} data
   * @param {import('./player.js').Player} player @param {import('./runs.js').Runs} runs
   */
  constructor(store, data, player, runs) {
    this.store = store;
    this.data = data;
    this.player = player;
    this.runs = runs;
    /** @type {{model: MotionModel, page: number, samples: import('../core/core.js').Sample[]} | null} */
    this.rolled = null;
    /** @type {{moments: number[], surface: import('../picture/surface.js').Surface} | null} */
    this.box = null;
    const invalidate = () => player.invalidate();
    this.bodyView = new BodyView(byId('body'), invalidate, data.scene.camera);
    this.sphereView = new SphereView(byId('sphere'), invalidate);
    this.poinsotView = new PoinsotView(byId('poinsot'), invalidate, data.scene.camera.azimuth);
    this.bodyView.moved = () => {
      const { azimuth, elevation, zoom } = this.bodyView.view;
      store.set({ view: [azimuth, elevation, zoom].map((x) => Number(x.toFixed(4))) });
    };
    makeTurnable(this.bodyView);
    makeTurnable(this.poinsotView);
    this.#makeStartDraggable();
    for (const view of [this.bodyView, this.poinsotView, this.sphereView]) {
      view.canvas.addEventListener('keydown', (event) => this.#key(view, event));
    }
  }

  #makeStartDraggable() {
    const view = this.sphereView;
    makeTurnable(view, (event) =>
      view.isAtStart(view.placeOf(event)) ? (moved) => this.#startAt(view.muAt(view.placeOf(moved))) : null,
    );
  }

  /** Has the motion start with the momentum in that direction, body axes. @param {number[]} mu */
  #startAt(mu) {
    if (this.model) this.store.set({ omega: this.model.omegaOf(mu) });
  }

  /** @param {import('../views/canvas_view.js').CanvasView} view @param {KeyboardEvent} event */
  #key(view, event) {
    const step = event.shiftKey ? stepOfStart / 10 : stepOfStart;
    /** @type {Record<string, number[]>} */
    const ways = { ArrowRight: [step, 0], ArrowLeft: [-step, 0], ArrowUp: [0, step], ArrowDown: [0, -step] };
    const way = view === this.sphereView ? ways[event.key] : undefined;
    if (way) this.#startAt(this.sphereView.muMoved(way[0], way[1]));
    else if (event.key === ' ') this.player.play(!this.player.playing);
    else if (!turnByKey(view, event)) return;
    event.preventDefault();
  }

  /** Has the body's view go where the state says. */
  follow() {
    const [azimuth, elevation, zoom] = this.store.state.view;
    this.bodyView.view = { azimuth, elevation, zoom };
  }

  /** The trail of the exact motion, or of a method, that ends at t. @param {MotionModel} model @param {{samples: (times: number[]) => import("../core/core.js").Samples}} source */
  #trail(model, source) {
    const { t } = this.store.state;
    return listed(source.samples(trailTimes(t, model.trailLength, Math.hypot(...model.omega))));
  }

  /** What the body view shows. @param {MotionModel} model */
  #bodyPicture(model) {
    const { state } = this.store;
    const trails = this.runs.runners.length
      ? this.runs.runners.map((runner) => this.#trail(model, runner))
      : [this.#trail(model, model.motion)];
    return {
      model,
      instants: trails.map((trail) => ({ sample: trail[trail.length - 1], trail })),
      ghost: state.compare === 'ghost',
      frame: state.frame,
      halfOpen: this.player.playing ? (shutter * state.speed) / framesPerSecond : 0,
      shown: Object.fromEntries(state.show.map((feature) => [feature, true])),
    };
  }

  /** Samples for the herpolhode, around t. @param {MotionModel} model */
  #herpolhode(model) {
    const { t } = this.store.state;
    const span = Math.min(
      this.data.scene.motion.duration,
      (pointsOfHerpolhode * widestTurn) / Math.max(Math.hypot(...model.omega), 1e-300),
    );
    const page = Math.floor(t / span);
    if (this.rolled?.model !== model || this.rolled.page !== page) {
      const times = Float64Array.from(
        { length: pointsOfHerpolhode + 1 },
        (_, i) => span * (page + i / pointsOfHerpolhode),
      );
      this.rolled = { model, page, samples: listed(model.motion.samples(times)) };
    }
    return this.rolled.samples;
  }

  /** The surface of the body that is chosen. */
  get #surface() {
    const { moments } = this.store.state;
    if (!moments) return this.data.surface;
    if (this.box?.moments !== moments) this.box = { moments, surface: boxSurface(moments) };
    return this.box.surface;
  }

  /**
   * Draws the three views.
   * @param {MotionModel} model @param {any} theme
   * @returns {number[]} the attitude that is shown
   */
  draw(model, theme) {
    this.model = model;
    const picture = this.#bodyPicture(model),
      trails = picture.instants.map(({ trail }) => trail),
      colors = theme.overlay;
    this.bodyView.setBody(this.#surface, theme);
    this.bodyView.draw(picture);
    this.sphereView.draw({ model, trails, colors });
    this.poinsotView.draw({ model, trail: trails[0], herpolhode: this.#herpolhode(model), colors });
    return picture.instants[0].sample.X;
  }

  /**
   * The body as a PNG of any size.
   * @param {MotionModel} model @param {any} theme @param {number} width @param {number} height in pixels
   * @returns {Promise<Blob>}
   */
  png(model, theme, width, height) {
    const { gl, canvas } = this.bodyView,
      size = [canvas.width, canvas.height],
      pixels = new Uint8Array(4 * width * height);
    [canvas.width, canvas.height] = [width, height];
    while (this.runs.advance(this.store.state.t));
    this.bodyView.setBody(this.#surface, theme);
    this.bodyView.draw(this.#bodyPicture(model));
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    [canvas.width, canvas.height] = size;
    this.player.invalidate();
    return pngOf(pixels, width, height);
  }
}
