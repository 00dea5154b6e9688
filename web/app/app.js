// The running page.
import { Announcer } from '../panels/announcer.js';
import { ComparePanel } from '../panels/compare.js';
import { Components } from '../panels/components.js';
import { DataTable } from '../panels/data_table.js';
import { BodyPanel, InteriorPanel, StartPanel } from '../panels/start.js';
import { listenToKeys } from '../panels/keys.js';
import { Timeline } from '../panels/timeline.js';
import { Transport } from '../panels/transport.js';
import { ViewPanel } from '../panels/view_panel.js';
import { setLanguage } from '../words/words.js';
import { CoreError, diagonal } from '../core/core.js';
import { firstOf } from '../core/motion.js';
import { byId, isOnScreen, showNote } from './dom.js';
import { Address } from './address.js';
import { readers, readLink } from './link.js';
import { MotionModel, samplesShown } from './motion_model.js';
import { noGraphics } from '../picture/graphics.js';
import { Pictures } from './pictures.js';
import { pageOf, Player } from './player.js';
import { Runs } from './runs.js';
import { initialState, replaced, Store } from './state.js';
import { TakeAway } from '../panels/take_away.js';
import { chartColors, lightTheme, setThemeColors } from './theme.js';

/** @import { Core } from '../core/core.js' */
/** @import { Graphics } from '../picture/graphics.js' */
/** @import { PageData, State } from './types' */
/** @typedef {{width: number, height: number, t?: number, theme?: string, show?: string[]}} PictureOptions */

const times = ['t', 'from']; // values that change in each frame while it plays
const ofMotion = /** @type {const} */ (['omega', 'moments', 'wheel', 'energy_loss_time']);
const mostPixels = 4096; // per side of a picture
const prefersLight = matchMedia('(prefers-color-scheme: light)');
const prefersStill = matchMedia('(prefers-reduced-motion: reduce)');

export class App {
  /** @param {PageData} data @param {Core} core @param {Graphics} graphics */
  constructor(data, core, graphics) {
    this.data = data;
    this.core = core;
    this.graphics = graphics;
    /** @type {(() => void)[]} Called when the reader's preferred theme changes. */
    this.themeListeners = [];
    if (data.recording) core.record(data.recording);
    this.store = new Store(initialState(data, navigator.languages));
    const methods = core.methods.map(({ name }) => name);
    this.known = readers(data, methods);
    this.model = this.#modelOf(this.store.state);
    this.runs = new Runs();
    this.announcer = new Announcer();
    this.player = new Player(this.store, () => this.draw());
    const { store, player } = this,
      invalidate = () => player.invalidate();
    this.pictures = new Pictures(store, data, player, this.runs, core, graphics, {
      body: byId('body'),
      sphere: byId('sphere'),
      poinsot: byId('poinsot'),
    });
    this.transport = new Transport(store, player, () => this.model);
    this.timeline = new Timeline(byId('timeline'), store, {
      invalidate,
      flip: (direction) => this.transport.toFlip(direction),
      step: (direction) => this.transport.step(direction),
      toggle: () => player.play(!player.playing),
    });
    listenToKeys({
      toggle: () => player.play(!player.playing),
      step: (direction) => this.transport.step(direction),
      isActive: () => isOnScreen(this.pictures.bodyView.canvas),
    });
    this.components = new Components(byId('components'), store, invalidate);
    this.startPanel = new StartPanel(store, data, () => this.model);
    this.interiorPanel = new InteriorPanel(store, data, this.model);
    this.bodyPanel = new BodyPanel(store, data);
    this.viewPanel = new ViewPanel(store, data);
    this.comparePanel = new ComparePanel(store, core, data, invalidate);
    this.table = new DataTable(invalidate);
    this.takeAway = new TakeAway({
      store,
      data,
      model: () => this.model,
      theme: () => this.themeName,
      link: () => this.address.link,
      picture: () => this.picture(this.pictures.bodyView.canvas),
    });
    this.store.subscribe((state, before) => this.#changed(state, before));
    this.address = new Address(this.store, this.known, this.player, (values) => this.#go(values));
    this.address.follow();
    addEventListener('resetview', () => this.pictures.bodyView.resetView());
    prefersLight.addEventListener('change', () => {
      this.#changed(this.store.state, this.store.state);
      for (const listener of this.themeListeners) listener();
    });
    byId('instead').hidden = true;
    byId('save-png').hidden = graphics === noGraphics;
    for (const id of ['live', 'tools', 'footer']) byId(id).hidden = false;
    this.#changed(this.store.state, { ...this.store.state, lang: /** @type {any} */ ('') });
  }

  /** Whether pictures do not play by themselves: the reader prefers it, or the browser cannot draw them. */
  get isStill() {
    return prefersStill.matches || this.graphics === noGraphics;
  }

  /** @param {State} state */
  #modelOf({ moments, omega, wheel, energy_loss_time: energyLossTime }) {
    const inertia = moments ? diagonal(moments) : this.data.inertia;
    const motion = this.core.motion(inertia, omega, { wheel, energyLossTime }, this.data.attitude);
    return new MotionModel(motion, this.data.scene.overlay.trail_length);
  }

  /** The name of the theme that is shown. @returns {string} */
  get themeName() {
    const { theme } = this.store.state;
    if (theme !== 'auto') return theme;
    const hasStills = this.graphics === noGraphics; // in the scene's theme
    return prefersLight.matches && !hasStills ? lightTheme(this.data) : this.data.scene.look.theme;
  }

  /**
   * Puts the page into the state of a link. Throws a CoreError if the motion is impossible.
   * @param {Partial<State>} values
   */
  #go(values) {
    const state = { ...this.store.initial, ...values };
    state.from = pageOf(state);
    const model = this.#modelOf(state),
      { longest } = model.facts;
    model.release();
    if (state.t > longest) throw new CoreError(`t: the motion is computed up to ${longest} s`);
    this.store.set(state);
    this.pictures.follow();
  }

  /** @param {State} state @param {State} before */
  #changed(state, before) {
    if (ofMotion.some((key) => state[key] !== before[key]) && !this.#follow(state, before)) return;
    const { kind, longest } = this.model.facts;
    if (Math.max(state.t, state.from + state.length) > longest) {
      const length = Math.min(state.length, longest);
      this.store.set({ t: Math.min(state.t, longest), from: Math.min(state.from, longest - length), length });
    }
    const exact = state.compare === 'off' || kind ? -1 : state.methods.indexOf('exact');
    if (exact >= 0) this.store.set({ methods: replaced(state.methods, exact, 'taylor') });
    /** @type {Record<string, any>} */
    const old = before;
    if (Object.entries(state).some(([key, value]) => !times.includes(key) && value !== old[key])) this.dirty = true;
    if (state.lang !== before.lang) {
      setLanguage(state.lang);
      for (const part of [this.viewPanel, this.comparePanel, this.transport, this.interiorPanel]) part.relabel();
    }
    this.player.invalidate();
  }

  /**
   * Changes the motion to that of the state. If it is impossible, restores the previous one, reports the
   * error, and returns false.
   * @param {State} state @param {State} before
   */
  #follow(state, before) {
    try {
      const last = this.model;
      this.model = this.#modelOf(state);
      this.runs.stop();
      last.release();
      showNote('interior-note', '');
      return true;
    } catch (error) {
      if (!(error instanceof CoreError)) throw error;
      this.store.set(before);
      showNote('interior-note', error.message);
      return false;
    }
  }

  /** The theme that is shown. @returns {any} */
  get theme() {
    return this.data.themes[this.themeName];
  }

  draw() {
    const { state } = this.store,
      { theme } = this;
    setThemeColors(theme);
    this.runs.prepare(state, this.model);
    if (this.runs.advance(state.t)) this.player.invalidate();
    this.#drawPanels(state, theme, this.pictures.draw([this.model], this.themeName, theme));
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
      this.startPanel.show(state, model);
      this.interiorPanel.show(state, model);
      this.bodyPanel.show(state, model);
      this.viewPanel.show(state);
      this.comparePanel.show(state, model);
      this.dirty = false;
    }
    this.table.draw(state, model);
    this.announcer.tell(model, state.t);
  }

  /** The motion shown. @param {number} t */
  sample(t) {
    return firstOf(samplesShown(this.store.state, this.model, [t]));
  }

  /**
   * The body at a time as a picture of any size.
   * @param {PictureOptions} options
   * @returns {Promise<Blob>} a PNG
   */
  picture({ width, height, t, theme, show }) {
    const fits = [width, height].every((size) => Number.isInteger(size) && size >= 1 && size <= mostPixels);
    if (this.graphics === noGraphics) throw new Error('WebGL 2 is not available in this browser');
    if (!fits) throw new RangeError(`picture: width and height must be whole numbers from 1 to ${mostPixels}`);
    if (theme !== undefined && !this.data.themes[theme]) throw new RangeError(`picture: unknown theme '${theme}'`);
    const { store } = this,
      before = store.state;
    store.state = { ...before, t: t ?? before.t, theme: theme ?? before.theme, show: show ?? before.show };
    try {
      return this.pictures.png([this.model], this.themeName, this.theme, width, height);
    } finally {
      store.state = before;
    }
  }
}
