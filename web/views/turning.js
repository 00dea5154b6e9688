// Turns and zooms a view: by dragging with one pointer, pinching with two, the wheel, and keys.

/** @import { CanvasView } from './canvas_view.js' */

const turnOfKey = 0.08,
  zoomOfKey = 1.12;

/** Directions of the arrow keys, across and up. @type {Record<string, number[]>} */
export const arrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

/** Zoom factors of keys. @type {Record<string, number>} */
const zooms = { '+': zoomOfKey, '=': zoomOfKey, '-': 1 / zoomOfKey, _: 1 / zoomOfKey };

/** @param {CanvasView} view */
export function makeTurnable(view) {
  const { canvas } = view;
  /** @type {Map<number, PointerEvent>} */
  const pointers = new Map();
  /** @type {((event: PointerEvent) => void) | null} */
  let held = null;
  canvas.addEventListener('pointerdown', (event) => {
    if (event.button > 0) return;
    canvas.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, event);
    if (pointers.size === 1) held = view.grab(event);
  });
  canvas.addEventListener('pointermove', (event) => {
    const before = pointers.get(event.pointerId);
    if (!before) return;
    if (held) held(event);
    else if (pointers.size === 1)
      turnBy(view, event.clientX - before.clientX, event.clientY - before.clientY);
    else pinch(view, [...pointers.values()], before, event);
    pointers.set(event.pointerId, event);
  });
  for (const type of /** @type {const} */ (['pointerup', 'pointercancel'])) {
    canvas.addEventListener(type, (event) => {
      pointers.delete(event.pointerId);
      held = null;
    });
  }
  canvas.addEventListener(
    'wheel',
    (event) => {
      const zooms = view.wheelZooms && (document.activeElement === canvas || document.fullscreenElement);
      if (!event.ctrlKey && !zooms) return; // the page scrolls
      event.preventDefault();
      view.zoom(Math.exp(-0.0015 * event.deltaY * (event.deltaMode === 1 ? 20 : 1)));
    },
    { passive: false },
  );
  canvas.addEventListener('dblclick', () => view.resetView());
}

/** @param {CanvasView} view @param {number} x @param {number} y in CSS pixels */
function turnBy(view, x, y) {
  const perPixel = Math.PI / Math.max(view.canvas.clientHeight, 1);
  view.turn(-x * perPixel, y * perPixel);
}

/** @param {CanvasView} view @param {PointerEvent[]} pointers @param {PointerEvent} before @param {PointerEvent} now */
function pinch(view, pointers, before, now) {
  const other = pointers.find((pointer) => pointer.pointerId !== now.pointerId);
  if (!other) return;
  const apart = (/** @type {PointerEvent} */ pointer) =>
    Math.hypot(pointer.clientX - other.clientX, pointer.clientY - other.clientY);
  view.zoom(apart(now) / Math.max(apart(before), 1));
}

/**
 * Turns and zooms by the arrow keys, plus and minus, 0.
 * @param {CanvasView} view @param {KeyboardEvent} event
 * @returns {boolean} whether the key was one of them
 */
export function turnByKey(view, event) {
  const step = event.shiftKey ? turnOfKey / 8 : turnOfKey,
    way = arrows[event.key],
    factor = zooms[event.key];
  if (way) view.turn(step * way[0], step * way[1]);
  else if (factor) view.zoom(factor);
  else if (event.key === '0') view.resetView();
  else return false;
  return true;
}
