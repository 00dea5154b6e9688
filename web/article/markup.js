// The texts of the article: {name} is a number, and [thing|words] are words in the colour of the thing.
import { element } from '../app/dom.js';

/** The features of a picture that show the things; the others cannot be stressed. @type {Record<string, string>} */
const featureOf = {
  momentum: 'momentum',
  omega: 'omega',
  trail: 'trail',
  plane: 'plane',
  least: 'axes',
  middle: 'axes',
  greatest: 'axes',
  centrifugal: 'forces',
  coriolis: 'forces',
  constraint: 'forces',
};

/**
 * A paragraph of a text.
 * @param {string} text
 * @param {readonly string[]} shown Features of the figure's picture. A word for one of them is a button that stresses it.
 * @param {(features: string[]) => void} stress
 */
export function paragraph(text, shown, stress) {
  const made = element('p');
  for (const [, name, thing, words, plain] of text.matchAll(/\{(\w+)\}|\[(\w+)\|([^\]]+)\]|([^[{]+)/g)) {
    if (name) made.append(numberElement(name));
    else if (thing) made.append(thingElement(thing, words, shown, stress));
    else made.append(plain);
  }
  return made;
}

/** @param {string} name */
function numberElement(name) {
  const made = element('span', 'number');
  made.dataset.number = name;
  return made;
}

/** @param {string} thing @param {string} words @param {readonly string[]} shown @param {(features: string[]) => void} stress */
function thingElement(thing, words, shown, stress) {
  const feature = featureOf[thing];
  if (!shown.includes(feature)) return colored(element('b', '', words), thing);
  const button = element('button', '', words);
  button.type = 'button';
  for (const type of ['pointerenter', 'focus']) button.addEventListener(type, () => stress([feature]));
  for (const type of ['pointerleave', 'blur']) button.addEventListener(type, () => stress([]));
  return colored(button, thing);
}

/** @param {HTMLElement} made @param {string} thing */
function colored(made, thing) {
  made.classList.add('thing');
  made.style.color = `var(--thing-${thing})`;
  return made;
}
