// Keys that work while the lab is on the screen unless the focused element uses them, and the list of all keys.
import { byId } from '../app/dom.js';

/** @typedef {{toggle: () => void, step: (direction: number) => void, isActive: () => boolean}} Actions */

/** Elements that use these keys. */
const owners = 'input, select, textarea, button, a, summary, canvas, [role=slider], dialog';

/** @param {Actions} actions */
export function listenToKeys({ toggle, step, isActive }) {
  const dialog = /** @type {HTMLDialogElement} */ (byId('keys'));
  /** @type {Record<string, () => void>} */
  const keys = {
    ' ': toggle,
    ArrowLeft: () => step(-1),
    ArrowRight: () => step(1),
  };
  addEventListener('keydown', (event) => {
    const target = /** @type {Element} */ (event.target);
    if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === '?' && !target.closest('input, textarea, dialog')) {
      event.preventDefault();
      dialog.showModal();
    } else if (keys[event.key] && isActive() && !target.closest(owners)) {
      event.preventDefault();
      keys[event.key]();
    }
  });
}
