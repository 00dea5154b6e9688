// Play, pause, step, flips, speed, and the length of the timeline.
import { byId, onClick, selectOf } from '../app/dom.js';
import { framesPerSecond, longestTime, seek } from '../app/player.js';
import { speedsAbout } from '../app/state.js';
import { clamp } from '../math/linear.js';
import { brief, decimal, duration, fillSelect, timeUnit, word } from '../words/words.js';
import { fieldText, readNumber } from './number_field.js';
import { PlayButton } from './play_button.js';

/** @import { MotionModel } from '../app/motion_model.js' */
/** @import { Player } from '../app/player.js' */
/** @import { Store } from '../app/state.js' */
/** @import { State } from '../app/types' */

const shortest = 1e-4; // s, a timeline whose times are written with a power of ten

/** A speed as 4 × or 1/4 ×, or as the time that passes in a second. @param {number} speed */
function speedText(speed) {
  if (speed < 1 / 16 || speed > 16) return `${duration(speed)}/s`;
  return `${speed >= 1 ? speed : `1/${1 / speed}`} ×`;
}

export class Transport {
  /** @param {Store} store @param {Player} player @param {() => MotionModel} model */
  constructor(store, player, model) {
    this.store = store;
    this.player = player;
    this.model = model;
    this.playButton = new PlayButton(byId('play'), player);
    this.time = /** @type {HTMLInputElement} */ (byId('t'));
    this.length = /** @type {HTMLInputElement} */ (byId('length'));
    this.speed = selectOf('speed', (speed) => store.set({ speed: Number(speed) }));
    onClick('step-back', () => this.step(-1));
    onClick('step-on', () => this.step(1));
    onClick('flip-back', () => this.toFlip(-1));
    onClick('flip-on', () => this.toFlip(1));
    onClick('shorter', () => this.#stretch(0.5));
    onClick('longer', () => this.#stretch(2));
    this.#readNumber(this.time, 0, (t) => seek(store, t));
    this.#readNumber(this.length, 1e-12, (length) => this.#stretch(length / store.state.length));
  }

  /** @param {HTMLInputElement} input @param {number} low @param {(value: number) => void} set */
  #readNumber(input, low, set) {
    input.addEventListener('change', () => readNumber(input, [low, longestTime], set, true));
    input.addEventListener('keydown', (event) => {
      if (event.key === 'Enter') input.blur();
    });
  }

  /** Moves by a frame of the film, forward or back. @param {number} direction */
  step(direction) {
    this.player.play(false);
    seek(this.store, this.store.state.t + (direction * this.store.state.speed) / framesPerSecond);
  }

  /** @param {number} direction 1 for the next, -1 for the previous */
  toFlip(direction) {
    const { t, length } = this.store.state,
      model = this.model();
    // At a flip, go to the next one instead of staying.
    const apart = 1e-9 * Math.max(t, length);
    const flip = direction > 0 ? model.nextFlip(t + apart) : model.previousFlip(t - apart);
    if (flip !== null && flip >= 0 && flip <= longestTime) seek(this.store, flip);
  }

  /** Stretches the timeline around t. @param {number} factor */
  #stretch(factor) {
    const { from, length, t } = this.store.state;
    const longer = clamp(length * factor, 1e-12, longestTime);
    const start = Math.max(0, t - ((t - from) / length) * longer);
    this.store.set({ from: t <= longer ? 0 : start, length: longer });
  }

  relabel() {
    this.playButton.relabel();
    this.#offerSpeeds();
  }

  /** Offers the scene's speeds, and the present one if it is different because of a link. */
  #offerSpeeds() {
    const { speed } = this.store.state,
      speeds = [...new Set([...speedsAbout(this.store.initial.speed), speed])].sort((a, b) => a - b);
    fillSelect(
      this.speed,
      speeds.map((one) => [String(one), speedText(one)]),
      String(speed),
    );
  }

  /** @param {State} state @param {MotionModel} model */
  show({ t, from, length, speed }, model) {
    const unit = timeUnit(from + length);
    const fine = 5 - Math.floor(Math.log10(length)),
      known = 10 - Math.floor(Math.log10(Math.max(t, 1)));
    const digits = clamp(Math.min(fine, known), 0, length < 1 ? 15 : 3),
      inUnit = clamp(5 - Math.floor(Math.log10(length / unit.length)), 0, 2);
    if (document.activeElement !== this.time)
      this.time.value = length < shortest ? fieldText(t, 4) : t.toFixed(digits);
    if (document.activeElement !== this.length) this.length.value = fieldText(length, 6);
    if (this.speed.value !== String(speed)) this.#offerSpeeds();
    const count = model.flipsUntil(t),
      flips = count < 1e9 ? count : brief(count),
      next = model.nextFlip(t);
    const now = Number(t.toPrecision(6)),
      text = word('timeText', `${decimal(t / unit.length, 1)} ${unit.symbol}`, flips);
    for (const [key, value] of Object.entries({ min: from, max: from + length, now, text }))
      byId('timeline').setAttribute(`aria-value${key}`, String(value));
    let says = word('noFlips');
    if (model.facts.turnsOver)
      says = `${word('flips', flips)} · ${next === null ? word('steady') : word('nextFlip', duration(next - t))}`;
    if (model.facts.losesEnergy) says = word('energyLeft', decimal(100 * model.energyLeft(t), 1));
    byId('readout').textContent = `t = ${decimal(t / unit.length, inUnit)} ${unit.symbol} · ${says}`;
    for (const id of ['flip-back', 'flip-on']) byId(id).toggleAttribute('disabled', !model.facts.turnsOver);
  }
}
