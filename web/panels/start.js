// The controls of the initial angular velocity, of what moves in the body, and of the moments: sliders and
// text fields.
import { byId, element, radiosOf, showNote } from '../app/dom.js';
import { column, dot, norm } from '../math/linear.js';
import { spunAbout } from '../app/motion_model.js';
import { replaced } from '../app/state.js';
import { brief, duration, precise, word } from '../words/words.js';
import { NumberField } from './number_field.js';

/** @import { MotionModel } from '../app/motion_model.js' */
/** @import { Phase } from '../core/types' */
/** @import { Store } from '../app/state.js' */
/** @import { PageData, State } from '../app/types' */

const push = 0.05; // deviation from the axis as a fraction of the rate, so that an unstable axis is recognisable

export class StartPanel {
  /** @param {Store} store @param {PageData} data @param {() => MotionModel} model */
  constructor(store, data, model) {
    const largest = Math.max(...store.initial.omega.map(Math.abs), 1e-9);
    this.fields = [0, 1, 2].map(
      (i) =>
        new NumberField(byId('omega'), {
          name: `ω${'xyz'[i]}`,
          label: () => `ω${'xyz'[i]}, rad/s`,
          range: [-2 * largest, 2 * largest],
          limits: data.limits.omega,
          set: (value) => store.set({ omega: replaced(store.state.omega, i, value) }),
        }),
    );
    ['aboutLeast', 'aboutMiddle', 'aboutGreatest'].forEach((key, i) => {
      const button = element('button', '', word(key));
      button.type = 'button';
      button.dataset.word = key;
      button.addEventListener('click', () =>
        store.set({ omega: spunAbout(model(), i, push), t: 0, from: 0 }),
      );
      byId('about').append(button);
    });
  }

  /** @param {State} state @param {MotionModel} model */
  show({ omega }, { facts: { phase } }) {
    this.fields.forEach((field, i) => field.show(omega[i]));
    showNote('phase', phase ? textOf(phase) : '');
  }
}

/** The angles of the rotation about L in one period. @param {Phase} phase */
const textOf = ({ period, total, dynamic, geometric }) =>
  word('phaseSays', duration(period), ...[total, dynamic, geometric].map(precise));

export class InteriorPanel {
  /** @param {Store} store @param {PageData} data @param {MotionModel} model */
  constructor(store, data, { facts }) {
    const { wheel, energy_loss_time } = data.limits,
      compared = data.scene.overlay.compare_wheel ?? [],
      { initial } = store;
    // A wheel can hold any rotation within this range: see docs/theory.md.
    const holding = (facts.moments[2] - facts.moments[0]) * norm(initial.omega),
      largest = Math.max(holding, ...[initial.wheel, ...compared].flat().map(Math.abs)) || 1,
      turn = (2 * Math.PI) / (facts.rate || 1);
    this.fields = [0, 1, 2].map(
      (i) =>
        new NumberField(byId('interior'), {
          name: `h${'xyz'[i]}`,
          label: () => `h${'xyz'[i]}, g cm²/s`,
          range: [-1.5 * largest, 1.5 * largest],
          limits: wheel,
          set: (value) => store.set({ wheel: replaced(store.state.wheel, i, value) }),
        }),
    );
    this.loss = new NumberField(byId('interior'), {
      name: 'τ',
      label: () => 'τ, s',
      hint: () => word('lossHint'),
      range: [turn, 1000 * turn],
      logarithmic: true,
      limits: [energy_loss_time[0], Infinity],
      set: (value) => {
        const time = value > energy_loss_time[1] ? Infinity : value;
        const length = time < Infinity ? 5 * time : initial.length; // then most of the energy is lost
        store.set({ energy_loss_time: time, t: 0, from: 0, length });
      },
    });
    for (const each of compared) {
      const button = element('button', '', `h = ${each.map(brief).join(', ')}`);
      button.type = 'button';
      button.addEventListener('click', () => store.set({ wheel: each, t: 0, from: 0 }));
      byId('compared').append(button);
    }
  }

  relabel() {
    for (const field of [...this.fields, this.loss]) field.relabel();
  }

  /** @param {State} state @param {MotionModel} model */
  show({ wheel, energy_loss_time }, { facts, omega }) {
    this.fields.forEach((field, i) => field.show(wheel[i]));
    this.loss.show(energy_loss_time);
    const [least, middle, greatest] = facts.moments,
      spin = Math.abs(dot(omega, column(facts.axes, 1)));
    const canBeHeld =
      least < middle && middle < greatest && spin > 0.95 * norm(omega) && !facts.losesEnergy;
    showNote('holding', canBeHeld ? word('holding', brief((greatest - middle) * spin)) : '');
  }
}

export class BodyPanel {
  /** @param {Store} store @param {PageData} data */
  constructor(store, data) {
    const own = [0, 4, 8].map((i) => data.inertia[i]);
    this.given = own.map((moment) => Number(moment.toPrecision(6)));
    this.range = rangeAbout(own);
    this.showChoice = radiosOf('body', (choice) =>
      store.set({ moments: choice === 'scene' ? null : this.given }),
    );
    this.fields = [0, 1, 2].map(
      (i) =>
        new NumberField(byId('moments'), {
          name: `I${'xyz'[i]}`,
          label: () => `I${'xyz'[i]}, g cm²`,
          range: rangeAbout(own),
          logarithmic: true,
          limits: data.limits.moment,
          set: (value) => store.set({ moments: replaced(store.state.moments ?? this.given, i, value) }),
        }),
    );
  }

  /** @param {State} state @param {MotionModel} model */
  show({ moments }, model) {
    this.showChoice(moments ? 'moments' : 'scene');
    byId('moments').hidden = !moments;
    if (moments) this.#showMoments(moments);
    showNote('moments-note', model.facts.isReal ? '' : word('unreal'));
  }

  /** @param {number[]} moments */
  #showMoments(moments) {
    const outside = moments.some((moment) => moment < this.range[0] || moment > this.range[1]);
    if (outside) this.range = rangeAbout(moments);
    this.fields.forEach((field, i) => {
      if (outside) field.setRange(this.range);
      field.show(moments[i]);
    });
  }
}

/** The range of the sliders of moments. @param {number[]} moments */
const rangeAbout = (moments) => [Math.min(...moments) / 10, 5 * Math.max(...moments)];
