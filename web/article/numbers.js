// The numbers in the texts of the article, by their names. The core computes them for the bodies shown.
import { evenly } from '../app/motion_model.js';
import { matrix } from '../core/motion.js';
import { column, dot, norm, scale, times } from '../math/linear.js';
import { brief, duration, precise, word } from '../words/words.js';

/** @import { MotionModel } from '../app/motion_model.js' */
/** @import { Samples } from '../core/types' */
/** @import { Axis } from './body.js' */
/** @import { Figure } from './figure.js' */

const samplesOfLean = 300;

/** @param {number} radians */
const degrees = (radians) => `${brief((180 / Math.PI) * radians)}°`;

/** @param {number} share */
const percent = (share) => `${brief(100 * share)} %`;

/**
 * The angles in rad between L and the end of a principal axis that is nearer to L at t = 0.
 * @param {Figure["body"]} body @param {number} axis @param {MotionModel} model @param {Samples} samples
 */
export function leans(body, axis, { facts }, { t, X }) {
  const end = body.axis(axis),
    direction = scale(dot(facts.momentum, end) < 0 ? -1 : 1, end);
  return Array.from(t, (_, i) => {
    const attitude = matrix(X, 9 * i),
      momentum = [0, 1, 2].map((k) => dot(column(attitude, k), facts.momentum)),
      along = dot(momentum, direction),
      across = norm(momentum.map((component, k) => component - along * direction[k]));
    return Math.atan2(across, along);
  });
}

/** The largest lean of each body in two intervals between flips. @param {Figure} figure @param {number} index of the body */
function largestLean({ body, axes, models }, index) {
  const model = models[index],
    end = 2 * Math.max(model.facts.flips?.interval ?? 0, body.interval);
  if (!Number.isFinite(end)) return Math.PI;
  return Math.max(...leans(body, axes[index], model, model.motion.samples(evenly(0, end, samplesOfLean))));
}

/** What happens to the body. @param {Figure} figure */
function fate({ body, models: [{ facts }] }) {
  const { flips, turnsOver, kind } = facts;
  if (!kind) return word('movesInside');
  if (kind === 'steady') return word('spinsSteadily');
  if (!flips) return circling(body, facts);
  if (!turnsOver) return word('wobbles', degrees(flips.swing));
  return word('turnsOver', duration(flips.interval));
}

/** How the axis of a symmetric body circles L. A ball has no such axis. @param {Figure["body"]} body @param {MotionModel["facts"]} facts */
function circling(body, { momentum, moments, axes }) {
  const single = /** @type {Axis[]} */ ([0, 2]).find((axis) => body.stability(axis).kind !== 'neutral');
  if (single === undefined) return word('spinsSteadily');
  const along = Math.abs(dot(column(axes, single), momentum)) / norm(momentum),
    period = (2 * Math.PI * moments[1]) / norm(momentum);
  return word('circles', degrees(Math.acos(Math.min(along, 1))), duration(period));
}

/** The torques in dyn cm of the centrifugal force that pull a leaning body back and over. @param {Figure} figure @param {number} lean degrees */
export function pulls({ body: { rate, tug } }, lean) {
  const torque = rate ** 2 * Math.sin((Math.PI / 180) * lean) * Math.cos((Math.PI / 180) * lean);
  return { back: torque * tug.across, over: torque * tug.along };
}

/** The time of one turn of a stable wobble, or of doubling. @param {Figure} figure @param {Axis} axis */
function timeScale({ body }, axis) {
  const { kind, rate } = body.stability(axis);
  return duration((kind === 'unstable' ? Math.LN2 : 2 * Math.PI) / rate);
}

/** Numbers that change only with the motions. @type {Record<string, (figure: Figure) => string>} */
const ofMotion = {
  interval: ({ models }) => duration(models[0].facts.flips?.interval ?? Infinity),
  first: ({ models }) => duration(models[0].facts.flips?.first ?? Infinity),
  swing: ({ models }) => degrees(models[0].facts.flips?.swing ?? 0),
  fate,
  file: ({ app }) => app.data.recording?.file ?? '',
  moments: ({ body }) => body.facts.moments.map(brief).join(', '),
  push: ({ value }) => percent(value),
  axis: ({ value }) => `${brief(value)}°`,
  lean: ({ value }) => `${brief(value)}°`,
  lean0: (figure) => degrees(largestLean(figure, 0)),
  lean1: (figure) => degrees(largestLean(figure, 1)),
  lean2: (figure) => degrees(largestLean(figure, 2)),
  over: (figure) => brief(pulls(figure, figure.value).over),
  back: (figure) => brief(pulls(figure, figure.value).back),
  period0: (figure) => timeScale(figure, 0),
  doubling: (figure) => timeScale(figure, 1),
  period2: (figure) => timeScale(figure, 2),
  wheel: ({ body, value }) => brief(value * body.holdingWheel),
  threshold: ({ body }) => brief(body.holdingWheel),
  decade: ({ body }) => duration(Math.LN10 / body.stability(1).rate),
};

/** @param {Figure} figure */
const omegaNow = ({ models, store }) => models[0].motion.at(store.state.t).omega;

/** @param {Figure} figure @param {number} index of a method */
const driftOf = ({ models, runs, store }, index) => {
  const samples = runs.runners[index].samples([store.state.t]);
  return brief(models[0].motion.diagnose(samples).energyDrift[0]);
};

/** The angle in rad between what a method shows and the motion. @param {Figure} figure @param {number} index of a method */
const angleOff = ({ models, runs, store }, index) => {
  const { error } = models[0].motion.diagnose(runs.runners[index].samples([store.state.t]));
  return 2 * Math.asin(Math.min(error[0] / Math.sqrt(8), 1));
};

/** Numbers that change with the time. @type {Record<string, (figure: Figure) => string>} */
const ofTime = {
  t: ({ store }) => duration(store.state.t),
  step: ({ store }) => duration(store.state.step),
  flips: ({ models, store }) => String(models[0].flipsUntil(store.state.t)),
  next: ({ models, store }) => duration((models[0].nextFlip(store.state.t) ?? Infinity) - store.state.t),
  momentum: (figure) => precise(norm(times(figure.body.inertia, omegaNow(figure)))),
  energy: (figure) => {
    const omega = omegaNow(figure);
    return precise(dot(omega, times(figure.body.inertia, omega)) / 2);
  },
  rate: (figure) => precise(norm(omegaNow(figure))),
  leanNow: ({ body, axes, models, store }) =>
    degrees(leans(body, axes[0], models[0], models[0].motion.samples([store.state.t]))[0]),
  left: ({ models, store }) => percent(models[1].energyLeft(store.state.t)),
  flipsA: ({ runs, store }) => String(runs.runners[0].flipsUntil(store.state.t)),
  flipsB: ({ runs, store }) => String(runs.runners[1].flipsUntil(store.state.t)),
  offA: (figure) => degrees(angleOff(figure, 0)),
  driftA: (figure) => driftOf(figure, 0),
  driftB: (figure) => driftOf(figure, 1),
};

/** Whether a number changes with the time. @param {string} name */
export const isOfTime = (name) => name in ofTime;

/** The number with a name, as text. @param {string} name @param {Figure} figure */
export const numberText = (name, figure) => (ofTime[name] ?? ofMotion[name])(figure);
