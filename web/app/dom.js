import { clamp } from '../math/linear.js';

/**
 * The element with that id.
 * @template {HTMLElement} [T=HTMLElement]
 * @param {string} id
 * @returns {T}
 */
export function byId(id) {
  return /** @type {T} */ (document.getElementById(id));
}

/**
 * A new element with a class and text.
 * @template {keyof HTMLElementTagNameMap} K
 * @param {K} tag @param {string} [className] @param {string} [text]
 * @returns {HTMLElementTagNameMap[K]}
 */
export function element(tag, className = '', text = '') {
  const made = document.createElement(tag);
  if (className) made.className = className;
  if (text) made.textContent = text;
  return made;
}

/** Whether a part of an element is on the screen now; observers report this later. @param {Element} shown */
export function isOnScreen(shown) {
  const { top, bottom } = shown.getBoundingClientRect();
  return top < innerHeight && bottom > 0;
}

/** Shows a note with this text, or hides it if the text is empty. @param {string} id @param {string} text */
export function showNote(id, text) {
  const note = byId(id);
  if (note.textContent !== text) note.textContent = text; // otherwise a screen reader would read it again
  note.hidden = text === '';
}

/** @param {string} id @param {() => void} act */
export const onClick = (id, act) => byId(id).addEventListener('click', act);

/** The select with that id; set() is called with the chosen value. @param {string} id @param {(value: any) => void} set */
export function selectOf(id, set) {
  /** @type {HTMLSelectElement} */
  const select = byId(id);
  select.addEventListener('change', () => set(select.value));
  return select;
}

/**
 * Radio buttons; set() is called with the value of the chosen one.
 * @param {string} name @param {(value: any) => void} set
 * @returns {(value: string) => void} checks the button with this value
 */
export function radiosOf(name, set) {
  /** @type {NodeListOf<HTMLInputElement>} */
  const radios = document.querySelectorAll(`input[name=${name}]`);
  for (const radio of radios) radio.addEventListener('change', () => set(radio.value));
  return (value) => radios.forEach((radio) => (radio.checked = radio.value === value));
}

/** A row of a table: its head and cells. @param {string} head @param {string[]} cells */
export function tableRow(head, cells) {
  const row = element('tr'),
    first = element('th', '', head);
  first.scope = 'row';
  row.append(first, ...cells.map((text) => element('td', '', text)));
  return row;
}

/** @param {unknown} error */
export const messageOf = (error) => (error instanceof Error ? error.message : String(error));

/**
 * Calls act() with the position of a pressed or dragged pointer as a fraction of the width between the
 * margins.
 * @param {HTMLElement} box @param {number} margin @param {(share: number) => void} act
 * @param {string[]} [ignored] Kinds of pointers.
 */
export function onDrag(box, margin, act, ignored = []) {
  const follow = (/** @type {PointerEvent} */ event) => {
    const { left, width } = box.getBoundingClientRect();
    act(clamp((event.clientX - left - margin) / (width - 2 * margin), 0, 1));
  };
  box.addEventListener('pointerdown', (event) => {
    if (ignored.includes(event.pointerType)) return;
    box.setPointerCapture(event.pointerId);
    follow(event);
  });
  box.addEventListener('pointermove', (event) => {
    if (box.hasPointerCapture(event.pointerId)) follow(event);
  });
}
