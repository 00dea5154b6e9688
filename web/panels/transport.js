// Play, pause, step, flips, speed, and the length of the timeline.
import { byId, onClick, selectOf } from '../app/dom.js';
import { framesPerSecond, seek } from '../app/player.js';
import { speeds } from '../app/state.js';
import { clamp } from '../math/linear.js';
import { brief, decimal, fillSelect, word } from '../words/words.js';
import { readNumber } from './number_field.js';

/** @import { MotionModel } from '../app/motion_model.js' */
/** @import { Player } from '../app/player.js' */
/** @import { Store } from '../app/state.js' */
/** @import { State } from '../app/types' */

const playIcon = 'M4 2 L15 9 L4 16 Z',
  pauseIcon = 'M3 2 H7 V16 H3 Z M11 2 H15 V16 H11 Z';

/** A speed as 4 or 1/4. @param {number} speed */
const speedText = (speed) => `${speed >= 1 ? speed : `1/${1 / speed}`} ×`;

export class Transport {
  /** @param {Store} store @param {Player} player @param {() => MotionModel} model */
  constructor(store, player, model) {
    this.store = store;
    this.player = player;
    this.model = model;
    this.playButton = byId('play');
    this.time = /** @type {HTMLInputElement} */ (byId('t'));
    this.length = /** @type {HTMLInputElement} */ (byId('length'));
    this.speed = selectOf('speed', (speed) => store.set({ speed: Number(speed) }));
    this.#makeIcon();
    onClick('play', () => player.play(!player.playing));
    onClick('step-back', () => this.step(-1));
    onClick('step-on', () => this.step(1));
    onClick('flip-back', () => this.toFlip(-1));
    onClick('flip-on', () => this.toFlip(1));
    onClick('shorter', () => this.#stretch(0.5));
    onClick('longer', () => this.#stretch(2));
    this.#readNumber(this.time, 0, (t) => seek(store, t));
    this.#readNumber(this.length, 1e-3, (length) => this.#stretch(length / store.state.length));
    player.listeners.push(() => this.relabel());
  }

  #makeIcon() {
    const space = 'http://www.w3.org/2000/svg';
    const svg = document.createElementNS(space, 'svg');
    svg.setAttribute('viewBox', '0 0 18 18');
    svg.setAttribute('width', '1em');
    svg.setAttribute('aria-hidden', 'true');
    this.icon = document.createElementNS(space, 'path');
    this.icon.setAttribute('fill', 'currentColor');
    svg.append(this.icon);
    this.playButton.replaceChildren(svg);
  }

  /** @param {HTMLInputElement} input @param {number} low @param {(value: number) => void} set */
  #readNumber(input, low, set) {
    input.addEventListener('change', () => readNumber(input, [low, 1e9], set, true));
    input.addEventListener('keydown', (event) => {
      if (event.key === 'Enter') input.blur();
    });
  }

  /** A film's frame on or back. @param {number} direction */
  step(direction) {
    this.player.play(false);
    seek(this.store, this.store.state.t + (direction * this.store.state.speed) / framesPerSecond);
  }

  /** @param {number} direction 1 for the next, -1 for the last */
  toFlip(direction) {
    const { t } = this.store.state,
      model = this.model();
    // Where it already is at a flip, the next one but that.
    const apart = 1e-9 * Math.max(Math.abs(t), 1);
    const flip = direction > 0 ? model.nextFlip(t + apart) : model.previousFlip(t - apart);
    if (flip !== null && flip >= 0 && flip <= 1e9) seek(this.store, flip);
  }

  /** Makes the timeline longer, around t. @param {number} factor */
  #stretch(factor) {
    const { from, length, t } = this.store.state;
    const longer = clamp(length * factor, 1e-3, 1e9);
    const start = Math.max(0, t - ((t - from) / length) * longer);
    this.store.set({ from: t <= longer ? 0 : start, length: longer });
  }

  relabel() {
    const { playing } = this.player;
    this.icon?.setAttribute('d', playing ? pauseIcon : playIcon);
    this.playButton.ariaLabel = this.playButton.title = word(playing ? 'pause' : 'play');
    fillSelect(
      this.speed,
      speeds.map((speed) => [String(speed), speedText(speed)]),
      String(this.store.state.speed),
    );
  }

  /** @param {State} state @param {MotionModel} model */
  show({ t, from, length, speed }, model) {
    const fine = 3 - Math.floor(Math.log10(length / 100)),
      known = 10 - Math.floor(Math.log10(Math.max(t, 1)));
    const digits = Math.max(0, Math.min(fine, known, 3));
    if (document.activeElement !== this.time) this.time.value = t.toFixed(digits);
    if (document.activeElement !== this.length) this.length.value = String(Number(length.toPrecision(6)));
    this.speed.value = String(speed);
    const count = model.flipsUntil(t),
      flips = count < 1e9 ? count : brief(count),
      next = model.nextFlip(t);
    const now = Number(t.toPrecision(6)),
      text = word('timeText', decimal(t, 1), flips);
    for (const [key, value] of Object.entries({ min: from, max: from + length, now, text }))
      byId('timeline').setAttribute(`aria-value${key}`, String(value));
    const says = model.flips
      ? `${word('flips', flips)} · ${next === null ? word('steady') : word('nextFlip', brief(next - t))}`
      : word('noFlips');
    byId('readout').textContent = `t = ${decimal(t, Math.min(digits, 2))} s · ${says}`;
    for (const id of ['flip-back', 'flip-on']) byId(id).toggleAttribute('disabled', !model.flips);
  }
}
