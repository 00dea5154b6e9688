// A figure of the article: bodies that play, and one control. Its state has the form of the lab's, so the same
// views draw it.
import { Pictures } from '../app/pictures.js';
import { element } from '../app/dom.js';
import { Player } from '../app/player.js';
import { nameOf, Runs } from '../app/runs.js';
import { initialState, Store } from '../app/state.js';
import { chartColors } from '../app/theme.js';
import { NumberField } from '../panels/number_field.js';
import { PlayButton } from '../panels/play_button.js';
import { css } from '../views/canvas_view.js';
import { word } from '../words/words.js';
import { controls } from './controls.js';
import { LeanChart } from './lean_chart.js';
import { isOfTime, numberText, pulls } from './numbers.js';

/** @import { MotionModel } from '../app/motion_model.js' */
/** @import { App } from '../app/app.js' */
/** @import { Body } from './body.js' */
/** @import { State } from '../app/types' */
/** @import { FigureDescription } from './types' */

const zoomOfSeveral = 0.88; // leaves room for the names above the arrows
const axisNames = ['least', 'middle', 'greatest'];

export class Figure {
  /**
   * @param {FigureDescription} description @param {App} app @param {Body} body
   * @param {HTMLElement} section Contains the numbers of the texts; its id names the still.
   */
  constructor(description, app, body, section) {
    this.description = description;
    this.app = app;
    this.body = body;
    this.section = section;
    this.axes = description.spin.map((name) => axisNames.indexOf(name));
    this.control = controls[description.control];
    /** The value of the control, if it determines the motions. */
    this.value = description.value ?? description.push ?? 0;
    this.store = new Store(this.#initialState());
    /** @type {MotionModel[]} */
    this.models = [];
    this.player = new Player(this.store, () => this.draw());
    this.runs = new Runs();
    this.element = element('figure');
    this.names = element('div', 'figure-names');
    this.readout = element('p', 'readout');
    this.caption = element('figcaption');
    this.pictures = this.#makePictures();
    this.chart = description.chart ? this.#makeChart() : null;
    this.bars = description.bars ? this.#makeBars() : [];
    this.button = this.#makeButton();
    this.field = this.#makeField();
    this.element.append(this.readout, this.caption);
    this.store.subscribe((state, before) => this.#changed(state, before));
    this.#restart();
  }

  /** @returns {State} */
  #initialState() {
    const initial = initialState(this.app.data, navigator.languages),
      { flips, flipSeconds, show, frame = 'space', compare = 'off', methods = initial.methods } = this.description,
      { interval, moments } = this.body;
    if (this.description.control === 'sceneTime') return { ...initial, show, frame, compare };
    return {
      ...initial,
      show,
      frame,
      compare,
      methods,
      moments,
      view: [0, 0, this.axes.length > 1 ? zoomOfSeveral : 1],
      omega: this.body.spun(1, this.description.push ?? 0),
      step: Number((this.value / this.body.rate).toPrecision(2)), // the value is an angle in rad
      length: flips * interval,
      speed: interval / flipSeconds,
    };
  }

  #makePictures() {
    const { app, store, player, runs } = this,
      views = element('div', 'figure-views');
    /** @type {Record<string, HTMLElement>} */
    const boxes = { body: viewBox('bodyKeys') };
    if (this.description.sphere) boxes.sphere = viewBox('sphereKeys');
    Object.values(boxes).forEach(({ dataset }, pane, { length }) => {
      dataset.still = this.section.id;
      if (length > 1) dataset.pane = String(pane);
    });
    boxes.body.append(this.names);
    views.append(...Object.values(boxes).reverse());
    this.element.append(views);
    const pictures = new Pictures(store, app.data, player, runs, app.core, app.graphics, boxes);
    for (const view of pictures.views) view.wheelZooms = false;
    pictures.follow();
    return pictures;
  }

  #makeChart() {
    this.element.classList.add('charted');
    const box = element('div', 'figure-chart'),
      canvas = element('canvas');
    canvas.setAttribute('role', 'img');
    canvas.dataset.wordLabel = 'leanChartSays';
    box.append(canvas);
    this.element.append(box);
    return new LeanChart(box, () => this.player.invalidate());
  }

  /** Two bars from the middle: what pulls the body back, and what pulls it over. */
  #makeBars() {
    const box = element('div', 'tug'),
      bars = [element('span'), element('span')];
    box.ariaHidden = 'true';
    box.append(...bars);
    this.element.append(box);
    return bars;
  }

  #drawBars() {
    const { back, over } = pulls(this, this.value),
      [, most] = this.control.range(this),
      longest = Math.max(...Object.values(pulls(this, most)));
    [back, over].forEach((pull, i) => (this.bars[i].style.width = `${((100 * pull) / longest).toFixed(2)}%`));
  }

  #makeButton() {
    const button = element('button', 'primary round');
    button.type = 'button';
    this.element.append(button);
    this.player.listeners.push(() => this.element.classList.toggle('plays', this.player.playing));
    return new PlayButton(button, this.player);
  }

  /** The slider of the control. */
  #makeField() {
    const { control, element: figure } = this,
      { label, logarithmic } = control,
      range = control.range(this);
    if (label === undefined) return null;
    return new NumberField(figure, {
      label: () => word(label),
      range,
      logarithmic,
      limits: range,
      set: (value) => control.set(this, value),
    });
  }

  /** @param {State} state @param {State} before */
  #changed(state, before) {
    if (state.omega !== before.omega) this.#restart();
    if (this.description.loops && state.t > state.length) this.store.set({ t: 0, from: 0 });
    this.player.invalidate();
  }

  /** Sets the value of the control. @param {number} value */
  setValue(value) {
    this.value = value;
    this.#restart();
  }

  /** Makes the motions for the value of the control, and begins with their start. */
  #restart() {
    const last = this.models;
    const interiors = this.control.interiors?.(this) ?? [];
    const attitude = this.control.attitude?.(this);
    this.models = this.control.omegas(this).map((omega, i) => this.body.model(omega, interiors[i], attitude));
    this.runs.stop();
    for (const model of last) model.release();
    const { first = this.body.interval } = this.models[0].facts.flips ?? {},
      length = this.description.flips === 0 ? 1.15 * first : this.store.state.length;
    this.isNew = true;
    this.store.set({ t: 0, from: 0, length });
  }

  /** Stresses features of the picture. @param {string[]} features */
  stress(features) {
    this.pictures.stress = features;
    this.player.invalidate();
  }

  /** Updates what depends on the language. */
  relabel() {
    this.button.relabel();
    this.field?.relabel();
    const { compare, methods } = this.store.state,
      names = compare === 'off' ? this.#bodyNames() : methods.map(nameOf);
    this.names.replaceChildren(...names.map((name) => element('span', '', name)));
    this.isNew = true;
    this.player.invalidate();
  }

  /** Names of several bodies. */
  #bodyNames() {
    if (this.axes.length === 1) return [];
    const { names = this.axes.map((axis) => ['aboutLeast', 'aboutMiddle', 'aboutGreatest'][axis]) } = this.description;
    return names.map((name) => word(name));
  }

  draw() {
    const { store, models, runs, pictures, app } = this,
      { state } = store;
    runs.prepare(state, models[0]);
    if (runs.advance(state.t)) this.player.invalidate();
    const theme = app.theme;
    pictures.draw(models, app.themeName, theme);
    this.chart?.draw(this, chartColors(theme, app.themeName), css(theme.overlay.trail));
    if (this.bars.length) this.#drawBars();
    if (this.field) {
      this.field.setRange(this.control.range(this));
      this.field.show(this.control.value(this));
    }
    this.#writeNumbers();
  }

  #writeNumbers() {
    for (const place of /** @type {NodeListOf<HTMLElement>} */ (this.section.querySelectorAll('[data-number]'))) {
      const name = /** @type {string} */ (place.dataset.number);
      if (!this.isNew && !isOfTime(name)) continue;
      const text = numberText(name, this);
      if (place.textContent !== text) place.textContent = text;
    }
    this.isNew = false;
  }
}

/** A box for a view. @param {string} label The key of the word that describes it. */
function viewBox(label) {
  const box = element('div', 'view'),
    canvas = element('canvas');
  canvas.tabIndex = 0;
  canvas.setAttribute('role', 'application');
  canvas.dataset.wordLabel = label;
  box.append(canvas);
  return box;
}
