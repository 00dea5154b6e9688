// The controls of figures. The value of a control determines the motions of its figure, the time, or the step of
// the methods.
import { seek } from '../app/player.js';

/** @import { Interior, Matrix } from '../core/types' */
/** @import { Axis } from './body.js' */
/** @import { Figure } from './figure.js' */
/** @import { ControlName } from './types' */
/**
 * @typedef {object} Control
 * @property {string} [label] The key of its word; without it there is no slider.
 * @property {boolean} [logarithmic]
 * @property {(figure: Figure) => number[]} range
 * @property {(figure: Figure) => number} value
 * @property {(figure: Figure, value: number) => void} set
 * @property {(figure: Figure) => number[][]} omegas The angular velocities of the bodies at t = 0.
 * @property {(figure: Figure) => Interior[]} [interiors] What moves in the bodies; default: nothing.
 * @property {(figure: Figure) => Matrix | undefined} [attitude] At t = 0; default: the identity.
 */

const degree = Math.PI / 180;

/** Every body spins about its axis with the same push. @param {Figure} figure @param {number} [push] */
const spins = ({ axes, body, description }, push = description.push ?? 0) =>
  axes.map((axis) => body.spun(/** @type {Axis} */ (axis), push));

/** A value of the figure. A change starts the motion again. */
const own = {
  value: (/** @type {Figure} */ { value }) => value,
  set: (/** @type {Figure} */ figure, /** @type {number} */ value) => figure.setValue(value),
};

/** The time. */
const timeline = {
  label: 'timeOfFigure',
  range: (/** @type {Figure} */ { store: { state } }) => [state.from, state.from + state.length],
  value: (/** @type {Figure} */ { store }) => Number(store.state.t.toPrecision(4)),
  set: (/** @type {Figure} */ { store }, /** @type {number} */ t) => seek(store, t),
};

/** @type {Record<ControlName, Control>} */
export const controls = {
  time: { ...timeline, omegas: (figure) => spins(figure) },
  sceneTime: {
    ...timeline,
    omegas: ({ app }) => [app.data.scene.motion.omega],
    interiors: ({ store: { initial } }) => [{ wheel: initial.wheel, energyLossTime: initial.energy_loss_time }],
    attitude: ({ app }) => app.data.attitude,
  },
  push: {
    ...own,
    label: 'push',
    logarithmic: true,
    range: () => [1e-3, 0.3],
    omegas: (figure) => spins(figure, figure.value),
  },
  delay: {
    ...own,
    label: 'push',
    logarithmic: true,
    range: () => [1e-9, 0.1],
    omegas: (figure) => spins(figure, figure.value),
  },
  axis: {
    ...own,
    label: 'axis',
    range: () => [0, 180],
    omegas: ({ body, value }) => [body.between(degree * value)],
  },
  lean: {
    ...own,
    label: 'lean',
    range: () => [1, 30],
    omegas: ({ body, value }) => [body.leaning(degree * value)],
  },
  wheel: {
    label: 'wheel',
    range: ({ body }) => [0, 2 * body.holdingWheel],
    value: ({ body, value }) => Number((value * body.holdingWheel).toPrecision(4)),
    set: (figure, wheel) => figure.setValue(wheel / figure.body.holdingWheel),
    omegas: (figure) => spins(figure),
    interiors: ({ body, value }) => [
      { wheel: body.wheel(value * body.holdingWheel), energyLossTime: Infinity },
      { wheel: body.wheel(0), energyLossTime: body.lossTime },
    ],
  },
  start: {
    range: () => [],
    value: () => NaN,
    set: () => {},
    omegas: ({ store }) => [store.state.omega],
  },
  step: {
    label: 'step',
    logarithmic: true,
    range: ({ body }) => [0.05 / body.rate, 1 / body.rate],
    value: ({ store }) => store.state.step,
    set: ({ store }, step) => store.set({ step, t: 0, from: 0 }),
    omegas: (figure) => spins(figure),
  },
};
