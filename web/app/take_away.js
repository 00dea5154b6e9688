// The texts that the reader can copy or save: the command line that renders the motion as a film, its
// scene file, its data.
import { clamp } from '../math/linear.js';
import { recorded } from '../core/motion.js';
import { word } from '../words/words.js';
import { samplesShown } from './motion_model.js';
import { textOf } from './link.js';
import { features, hasMeaning, isRigid, noInterior } from './state.js';

/** @import { MotionModel } from './motion_model.js' */
/** @import { PageData, State } from './types' */

const mostRows = 20001;
const tightest = 1e-15; // the tolerance of the motion shown, if it has no closed form

/** Quotes a word for a shell. @param {string} text */
const quoted = (text) => (/^[\w./:@%+=,-]+$/.test(text) ? text : `'${text.replaceAll("'", "'\\''")}'`);

/** @param {string} option @param {number | string | string[] | number[]} value */
const optionOf = (option, value) =>
  `--${option.replaceAll('_', '-')}${textOf(value).startsWith('-') ? '=' : ' '}${quoted(textOf(value))}`;

/** @param {any} a @param {any} b */
const differ = (a, b) => String(a) !== String(b);

/**
 * Whether the recorded motion is shown beside the motion that the program compares it with.
 * @param {State} state @param {PageData} data
 */
const showsRecording = ({ compare, methods, omega }, { recording, scene }) =>
  Boolean(recording) && compare !== 'off' && methods.includes(recorded) && !differ(omega, scene.motion.omega);

/**
 * The values of the scene that the state may change, by table and key of scene files.
 * @param {State} state @param {PageData} data @param {string} theme The one shown. @param {MotionModel} model
 * @param {boolean} hasRecording Whether a recorded motion is shown, which determines the start.
 * @returns {[string, string, any][]}
 */
function valuesOf(state, data, theme, { facts }, hasRecording) {
  const { scene } = data,
    { camera, overlay } = scene;
  const [azimuth, elevation, zoom] = state.view;
  const methods = state.methods.filter((name) => name !== recorded),
    compared = state.compare !== 'off' && methods.length > 0,
    method = compared ? methods[0] : facts.kind ? 'exact' : 'taylor';
  /** @type {[string, string, any][]} */
  const start = [
    ['motion', 'omega', state.omega],
    ['motion', 'attitude', scene.motion.attitude],
    ['motion', 'method', method],
  ];
  /** @type {[string, string, any][]} */
  const all = [
    ...(hasRecording ? [] : start.filter(([, , value]) => value !== undefined)),
    ['motion', 'wheel', state.wheel],
    ['motion', 'energy_loss_time', state.energy_loss_time],
    ['motion', 'duration', Math.max(state.from + state.length, state.t)],
    ['film', 'speed', state.speed],
    ['look', 'theme', theme],
    ['camera', 'azimuth', camera.azimuth + azimuth],
    ['camera', 'elevation', clamp(camera.elevation + elevation, -Math.PI / 2, Math.PI / 2)],
    ['camera', 'distance', clamp(camera.distance / zoom, 0.2, 20)],
    ['camera', 'frame', state.frame],
  ];
  if (compared) {
    all.push(
      ['motion', 'step', state.step],
      ['motion', 'tolerance', state.tolerance],
      ['overlay', 'compare', methods],
    );
  } else if (!facts.kind) all.push(['motion', 'tolerance', tightest]);
  // One motion instead of those that the film compares.
  if (!compared && !hasRecording && overlay.compare?.length) all.push(['overlay', 'compare', [method]]);
  if (overlay.compare_wheel?.length) all.push(['overlay', 'compare_wheel', [state.wheel]]);
  const { view } = overlay,
    lacksSphere = state.show.includes('phase') && view === 'poinsot';
  if (lacksSphere || (!isRigid(state) && !['wrench', 'momentum'].includes(view))) all.push(['overlay', 'view', 'wrench']);
  return all;
}

/** Whether a value is not that of a scene. @param {[string, string, any]} value @param {Record<string, any>} scene */
function isChanged([table, key, value], scene) {
  /** @type {Record<string, any>} */
  const defaults = noInterior;
  return textOf(value) !== textOf(scene[table]?.[key] ?? defaults[key]);
}

/** The items to show: those of the film that cannot be chosen on the page, and the chosen ones. @param {State} state @param {PageData} data */
function shownFeatures(state, data) {
  const others = data.scene.overlay.show.filter((/** @type {string} */ name) => !features.includes(name));
  if (state.show.includes('phase')) others.push('sphere'); // on which it is shown
  return [...new Set([...others, ...state.show])].filter((name) => hasMeaning(name, state, data));
}

/** The commands for a motion that no options make of the scene. */
const commandsOfCopy = () => [`# ${word('notStory')}`, 'twrench render flip.toml -o flip.mp4'];

/**
 * The commands for the page of a film that tells a story. Its shots are not in the page, and each has its
 * own motion and camera, so no options turn the story into the motion shown here.
 * @param {string} source
 */
function storyCommands(source) {
  return [
    `# ${word('story')}`,
    `twrench render ${quoted(source)} -o story.mp4`,
    ...commandsOfCopy(),
  ].join('\n');
}

/**
 * The numbers of --inertia for the [body] of a scene: its moments, or Ixx, Iyy, Izz, Ixy, Ixz and
 * Iyz. None for a body of parts.
 * @param {{moments?: number[], inertia?: number[][]} | undefined} body
 */
function inertiaOf(body) {
  if (!body?.inertia) return body?.moments ?? [];
  const [[xx, xy, xz], [, yy, yz], [, , zz]] = body.inertia;
  return [xx, yy, zz, xy, xz, yz];
}

/**
 * The command that renders the motion shown as a film.
 * @param {State} state @param {PageData} data @param {string} theme @param {MotionModel} model
 */
export function commandLine(state, data, theme, model) {
  const source = data.source ?? data.scene.name,
    given = data.source_scene ?? data.scene;
  if (given.shot) return storyCommands(source);
  const hasRecording = showsRecording(state, data);
  // The scene file names the recording instead of a start.
  if (given.motion.recording && !hasRecording) return commandsOfCopy().join('\n');
  const parts = ['twrench render', ...[source, ...(data.source_options ?? [])].map(quoted)];
  if (hasRecording) parts.push(...(data.recording?.options ?? []).map(quoted));
  const inertia = state.moments ?? inertiaOf(data.scene.body);
  if (differ(inertia, inertiaOf(given.body))) parts.push(optionOf('inertia', inertia));
  for (const value of valuesOf(state, data, theme, model, hasRecording))
    if (isChanged(value, given)) parts.push(optionOf(value[1], value[2]));
  const show = shownFeatures(state, data),
    before = given.overlay.show;
  if (differ(data.scene.language, given.language)) parts.push(optionOf('language', data.scene.language));
  const hidden = before.filter((/** @type {string} */ feature) => !show.includes(feature));
  const added = show.filter((feature) => !before.includes(feature));
  if (hidden.length) parts.push(optionOf('hide', hidden));
  if (added.length) parts.push(optionOf('show', added));
  return `${parts.join(' ')} -o flip.mp4`;
}

/** A value in TOML. @param {any} value @returns {string} */
function toml(value) {
  if (Array.isArray(value)) return `[${value.map(toml).join(', ')}]`;
  if (typeof value !== 'string') return textOf(value);
  const escaped = (/** @type {string} */ c) => `\\u${c.charCodeAt(0).toString(16).padStart(4, '0')}`;
  return JSON.stringify(value).replace(/[\u007f-\u009f\u2028\u2029]/g, escaped);
}

/** @param {string} head @param {Record<string, any>} table */
const tomlTable = (head, table) =>
  [head, ...Object.entries(table).map(([key, value]) => `${key} = ${toml(value)}`), ''].join('\n');

/** The keys of a part that a scene file may have. A mesh without a wall is a solid. @param {Record<string, any>} part */
function partTable({ sha256, shell, ...rest }) {
  return shell ? { ...rest, shell } : rest;
}

/**
 * The scene file of this motion.
 * @param {State} state @param {PageData} data @param {string} theme @param {MotionModel} model
 */
export function sceneFile(state, data, theme, model) {
  const { part, body, shot, name, title, language, ...tables } = structuredClone(data.scene);
  delete tables.motion.recording; // a scene file gives the computed motion
  for (const value of valuesOf(state, data, theme, model, false)) {
    const [table, key] = value;
    if (isChanged(value, tables)) (tables[table] ??= {})[key] = value[2];
  }
  tables.overlay.show = shownFeatures(state, data);
  const texts = [
    `# Lengths in centimetres, masses in grams, times in seconds, angles in radians.\ntitle = ${toml(title ?? '')}\nlanguage = ${toml(language ?? 'en')}\n`,
  ];
  if (state.moments) texts.push(tomlTable('[body]', { moments: state.moments }));
  else if (body) texts.push(tomlTable('[body]', body));
  else for (const each of part ?? []) texts.push(tomlTable('[[part]]', partTable(each)));
  for (const [key, table] of Object.entries(tables)) {
    if (table && typeof table === 'object' && !Array.isArray(table)) texts.push(tomlTable(`[${key}]`, table));
  }
  return texts.join('\n');
}

/**
 * The times of the film's frames, or of every second, third ... one, with both ends. If the timeline
 * starts at 0, they are exactly those of twrench simulate.
 * @param {State} state @param {number} fps
 */
function timesOf({ from, length }, fps) {
  const frames = Math.floor(length * fps),
    every = Math.ceil((frames + 1) / mostRows);
  const times = Array.from({ length: Math.floor(frames / every) + 1 }, (_, i) => from + (i * every) / fps);
  return times[times.length - 1] < from + length ? [...times, from + length] : times;
}

/**
 * The fewest digits that read back as the number, in the shorter of both notations, as
 * std::to_chars writes it.
 * @param {number} x
 */
export function shortestDigits(x) {
  if (x === 0) return Object.is(x, -0) ? '-0' : '0';
  const [mantissa, power] = Math.abs(x).toExponential().split('e'),
    exponent = Number(power);
  const digits = mantissa.replace('.', '');
  const scientific = `${mantissa}e${exponent < 0 ? '-' : '+'}${String(Math.abs(exponent)).padStart(2, '0')}`;
  const whole = exponent + 1; // the digits before the point
  let fixed = `0.${'0'.repeat(Math.max(-whole, 0))}${digits}`;
  if (whole >= digits.length) fixed = BigInt(Math.abs(x)).toString();
  else if (whole > 0) fixed = `${digits.slice(0, whole)}.${digits.slice(whole)}`;
  return (x < 0 ? '-' : '') + (fixed.length <= scientific.length ? fixed : scientific);
}

/**
 * The motion shown over the timeline, as twrench simulate writes it.
 * @param {State} state @param {MotionModel} model @param {number} fps
 */
export function csv(state, model, fps) {
  const samples = samplesShown(state, model, timesOf(state, fps)),
    found = model.motion.diagnose(samples);
  const drift = model.facts.losesEnergy ? '' : ',energy_drift';
  const lines = [
    `t,x11,x12,x13,x21,x22,x23,x31,x32,x33,wx,wy,wz,energy${drift},orthogonality_error,momentum_error`,
  ];
  const { t, X, omega } = samples;
  const drifts = drift ? [found.energyDrift] : [];
  const columns = [found.energy, ...drifts, found.orthogonalityError, found.momentumError];
  t.forEach((time, i) => {
    const motion = [time, ...X.subarray(9 * i, 9 * i + 9), ...omega.subarray(3 * i, 3 * i + 3)];
    lines.push([...motion, ...columns.map((column) => column[i])].map(shortestDigits).join(','));
  });
  return lines.join('\n') + '\n';
}
