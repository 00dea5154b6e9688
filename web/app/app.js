// The page at work.
import { BodyView } from '../views/body_view.js';
import { PoinsotView } from '../views/poinsot_view.js';
import { SphereView } from '../views/sphere_view.js';
import { makeTurnable, turnByKey } from '../views/turning.js';
import { Announcer } from '../panels/announcer.js';
import { ComparePanel } from '../panels/compare.js';
import { Components } from '../panels/components.js';
import { DataTable } from '../panels/data_table.js';
import { BodyPanel, StartPanel } from '../panels/start.js';
import { Timeline } from '../panels/timeline.js';
import { Tour } from '../panels/tour.js';
import { Transport } from '../panels/transport.js';
import { ViewPanel } from '../panels/view_panel.js';
import { pngOf } from '../picture/png.js';
import { boxSurface, surfaceOf } from '../picture/surface.js';
import { setLanguage } from '../words/words.js';
import tour from '../tour/tour.json';
import { byId } from './dom.js';
import { Address } from './address.js';
import { readers, readLink } from './link.js';
import { figuresOf, listed, MotionModel, spunAbout, trailTimes } from './motion_model.js';
import { framesPerSecond, pageOf, Player } from './player.js';
import { Runs } from './runs.js';
import { initialState, Store } from './state.js';
import { TakeAway } from '../panels/take_away.js';
import { chartColors, setThemeColors } from './theme.js';

/** @typedef {import("./state.js").State} State */
/** @typedef {{width: number, height: number, t?: number, theme?: import("./state.js").ThemeName, show?: string[]}} PictureOptions */

const pointsOfHerpolhode = 1200,
  widestTurn = 0.35;
const shutter = 0.25; // half of half the time between two frames, as in the film
const threeMoments = [700, 1000, 1500]; // g cm^2, for the tour of a body without three different ones

export class App {
  /** @param {import("./page_data.js").PageData} data @param {import("../core/core.js").Core} core */
  constructor(data, core) {
    this.data = data;
    this.core = core;
    this.store = new Store(initialState(data, navigator.languages));
    this.known = readers(
      data,
      core.methods.map(({ name }) => name),
      tour.steps.length,
    );
    this.sceneSurface = surfaceOf(data.surface);
    this.model = this.#modelOf(this.store.state);
    this.runs = new Runs();
    this.announcer = new Announcer();
    /** @type {{model: MotionModel, page: number, samples: import("../core/core.js").Sample[]} | null} */
    this.rolled = null;
    /** @type {{moments: number[], surface: import("../picture/surface.js").Surface} | null} */
    this.box = null;
    this.player = new Player(this.store, () => this.draw());
    const { store, player } = this,
      invalidate = () => player.invalidate();
    this.bodyView = new BodyView(byId('body'), invalidate, data.scene.camera);
    this.sphereView = new SphereView(byId('sphere'), invalidate);
    this.poinsotView = new PoinsotView(byId('poinsot'), invalidate, data.scene.camera.azimuth);
    this.transport = new Transport(store, player, () => this.model);
    this.timeline = new Timeline(byId('timeline'), store, {
      invalidate,
      flip: (direction) => this.transport.toFlip(direction),
      step: (direction) => this.transport.step(direction),
      toggle: () => player.play(!player.playing),
    });
    this.components = new Components(byId('components'), store, invalidate);
    this.startPanel = new StartPanel(store, data, () => this.model);
    this.bodyPanel = new BodyPanel(store, data);
    this.viewPanel = new ViewPanel(store, data);
    this.comparePanel = new ComparePanel(store, core, data, invalidate);
    this.table = new DataTable(invalidate);
    this.tour = new Tour(
      /** @type {any} */ (tour.steps),
      store,
      (step) => this.#enter(step),
      () => figuresOf(this.model),
    );
    this.takeAway = new TakeAway({
      store,
      data,
      model: () => this.model,
      theme: () => this.themeName,
      link: () => this.address.link,
      picture: () => this.picture({ width: this.bodyView.canvas.width, height: this.bodyView.canvas.height }),
    });
    this.#makeKeys();
    this.store.subscribe((state, before) => this.#changed(state, before));
    this.address = new Address(this.store, this.known, this.player, (values) => this.#go(values));
    this.address.follow();
    addEventListener('resetview', () => this.bodyView.resetView());
    matchMedia('(prefers-color-scheme: light)').addEventListener('change', () =>
      this.#changed(this.store.state, this.store.state),
    );
    byId('instead').hidden = true;
    for (const id of ['live', 'tools', 'footer']) byId(id).hidden = false;
    this.#changed(this.store.state, { ...this.store.state, lang: /** @type {any} */ ('') });
    this.player.play(!matchMedia('(prefers-reduced-motion: reduce)').matches);
  }

  #makeKeys() {
    const { bodyView, sphereView, poinsotView, player, store } = this;
    bodyView.moved = () => {
      const { azimuth, elevation, zoom } = bodyView.view;
      store.set({ view: [azimuth, elevation, zoom].map((x) => Number(x.toFixed(4))) });
    };
    const startAt = (/** @type {number[]} */ mu) => store.set({ omega: this.model.omegaOf(mu) });
    makeTurnable(bodyView);
    makeTurnable(poinsotView);
    makeTurnable(sphereView, (event) =>
      sphereView.isAtStart(sphereView.placeOf(event))
        ? (moved) => startAt(sphereView.muAt(sphereView.placeOf(moved)))
        : null,
    );
    for (const view of [bodyView, poinsotView]) {
      view.canvas.addEventListener('keydown', (event) => {
        if (event.key === ' ') player.play(!player.playing);
        else if (!turnByKey(view, event)) return;
        event.preventDefault();
      });
    }
    sphereView.canvas.addEventListener('keydown', (event) => {
      const step = event.shiftKey ? 0.002 : 0.02;
      const way = { ArrowRight: [step, 0], ArrowLeft: [-step, 0], ArrowUp: [0, step], ArrowDown: [0, -step] }[
        event.key
      ];
      if (way) startAt(sphereView.muMoved(way[0], way[1]));
      else if (event.key === ' ') player.play(!player.playing);
      else if (!turnByKey(sphereView, event)) return;
      event.preventDefault();
    });
  }

  /** @param {State} state */
  #modelOf({ moments, omega }) {
    const inertia = moments ? [moments[0], 0, 0, 0, moments[1], 0, 0, 0, moments[2]] : this.data.inertia;
    return new MotionModel(this.core, inertia, omega, this.data.scene.overlay.trail_length);
  }

  /** The theme that is shown. @returns {import("./state.js").ThemeName} */
  get themeName() {
    const { theme } = this.store.state;
    if (theme !== 'auto') return theme;
    return matchMedia('(prefers-color-scheme: light)').matches ? 'paper' : this.data.scene.look.theme;
  }

  /**
   * Puts the page into the state of a link. Throws a CoreError for a motion that there cannot be.
   * @param {Partial<State>} values
   */
  #go(values) {
    const state = { ...this.store.initial, ...values };
    state.from = pageOf(state);
    this.#modelOf(state).release();
    this.store.set(state);
    this.#follow(state);
    const isTourAlone = Object.keys(values).every((key) => ['tour', 'lang', 'theme'].includes(key));
    if (state.tour && isTourAlone) this.#enter(/** @type {any} */ (tour.steps[state.tour - 1]));
  }

  /** Has the view go where the state says. @param {State} state */
  #follow({ view: [azimuth, elevation, zoom] }) {
    this.bodyView.view = { azimuth, elevation, zoom };
  }

  /** Puts the page into the state of a step of the tour. @param {import("../panels/tour.js").TourStep} step */
  #enter({ spin, push, state, play }) {
    const {
      initial,
      state: { lang, theme, tour: number },
    } = this.store;
    const { values } = readLink(state, this.known);
    const next = { ...initial, ...values, lang, theme, tour: number };
    const own = this.#modelOf(initial),
      [least, middle, greatest] = own.facts.moments;
    own.release();
    if (Math.min(middle - least, greatest - middle) < 0.01 * greatest) next.moments = threeMoments;
    const body = this.#modelOf(next);
    next.omega = spunAbout(body, ['least', 'middle', 'greatest'].indexOf(spin), push);
    body.release();
    this.store.set(next);
    this.#follow(next);
    this.player.play(play && !matchMedia('(prefers-reduced-motion: reduce)').matches);
  }

  /** @param {State} state @param {State} before */
  #changed(state, before) {
    if (state.omega !== before.omega || state.moments !== before.moments) {
      const last = this.model;
      this.model = this.#modelOf(state);
      this.runs.stop();
      last.release();
    }
    this.dirty = true;
    if (state.lang !== before.lang) {
      setLanguage(state.lang);
      for (const part of [this.viewPanel, this.comparePanel, this.transport]) part.relabel();
    }
    this.player.invalidate();
  }

  /** The trail of the exact motion, or of a method, that ends at t. @param {{samples: (times: number[]) => import("../core/core.js").Samples}} source */
  #trail(source) {
    const { state } = this.store;
    return listed(source.samples(trailTimes(state.t, this.model.trailLength, Math.hypot(...state.omega))));
  }

  /** What the body view shows. */
  #bodyPicture() {
    const { state } = this.store;
    const trails = this.runs.runners.length
      ? this.runs.runners.map((runner) => this.#trail(runner))
      : [this.#trail(this.model.motion)];
    return {
      model: this.model,
      instants: trails.map((trail) => ({ sample: trail[trail.length - 1], trail })),
      ghost: state.compare === 'ghost',
      frame: state.frame,
      halfOpen: this.player.playing ? (shutter * state.speed) / framesPerSecond : 0,
      shown: Object.fromEntries(state.show.map((feature) => [feature, true])),
    };
  }

  /** Samples for the herpolhode, around t. */
  #herpolhode() {
    const {
      model,
      store: {
        state: { t },
      },
    } = this;
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

  /** @param {State} state */
  #surface({ moments }) {
    if (!moments) return this.sceneSurface;
    if (this.box?.moments !== moments) this.box = { moments, surface: boxSurface(moments) };
    return this.box.surface;
  }

  draw() {
    const {
      store: { state },
      model,
      data,
    } = this;
    const theme = data.themes[this.themeName],
      colors = theme.overlay;
    setThemeColors(this.themeName);
    try {
      this.runs.prepare(state, model);
    } catch (error) {
      this.store.set({ compare: 'off' });
      byId('compare-note').hidden = false;
      byId('compare-note').textContent = error instanceof Error ? error.message : String(error);
      return;
    }
    if (this.runs.advance(state.t)) this.player.invalidate();
    const picture = this.#bodyPicture(),
      trails = picture.instants.map(({ trail }) => trail);
    this.bodyView.setBody(this.#surface(state), theme);
    this.bodyView.draw(picture);
    this.sphereView.draw({ model, trails, colors });
    this.poinsotView.draw({ model, trail: trails[0], herpolhode: this.#herpolhode(), colors });
    this.#drawPanels(state, theme, picture.instants[0].sample.X);
  }

  /** @param {State} state @param {any} theme @param {number[]} X */
  #drawPanels(state, theme, X) {
    const { model } = this,
      colors = chartColors(theme, this.themeName);
    const detail = this.components.cover(state, model);
    this.components.draw(state, colors, X);
    this.timeline.draw(state, model, colors, this.components.chart.isShown ? detail : null);
    this.comparePanel.draw(state, model, this.runs, colors);
    this.transport.show(state, model);
    if (this.dirty) {
      this.startPanel.show(state);
      this.bodyPanel.show(state, model);
      this.viewPanel.show(state);
      this.comparePanel.show(state);
      this.tour.show(state);
      this.dirty = false;
    }
    this.table.draw(state, model);
    this.announcer.tell(model, state.t);
  }

  /** The motion shown, as the command line that the page gives has it computed. @param {number} t */
  sample(t) {
    const { compare, methods, step, tolerance } = this.store.state;
    if (compare === 'off') return this.model.motion.at(t);
    return listed(this.model.motion.integrate(methods[0], { step, tolerance }, [t]))[0];
  }

  /**
   * The body at a time as a picture of any size.
   * @param {PictureOptions} options
   * @returns {Promise<Blob>} a PNG
   */
  picture({ width, height, t, theme, show }) {
    const { bodyView, store } = this,
      { canvas } = bodyView,
      before = store.state,
      size = [canvas.width, canvas.height];
    store.state = { ...before, t: t ?? before.t, theme: theme ?? before.theme, show: show ?? before.show };
    [canvas.width, canvas.height] = [width, height];
    try {
      while (this.runs.advance(store.state.t));
      bodyView.setBody(this.#surface(store.state), this.data.themes[this.themeName]);
      bodyView.draw(this.#bodyPicture());
      const { gl } = bodyView,
        pixels = new Uint8Array(4 * width * height);
      gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
      return pngOf(pixels, width, height);
    } finally {
      store.state = before;
      [canvas.width, canvas.height] = size;
      this.player.invalidate();
    }
  }
}
