// The controls of the initial angular velocity and of the moments: sliders and text fields.
import { byId, element, radiosOf, showNote } from '../app/dom.js';
import { spunAbout } from '../app/motion_model.js';
import { replaced } from '../app/state.js';
import { word } from '../words/words.js';
import { NumberField } from './number_field.js';

/** @import { MotionModel } from '../app/motion_model.js' */
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

  /** @param {State} state */
  show({ omega }) {
    this.fields.forEach((field, i) => field.show(omega[i]));
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
