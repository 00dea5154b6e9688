// The pictures that the program drew for the views (src/page/stills.h): a view shows its own until it draws.

const edge = 1; // pixels at the edges of a pane, into which its neighbours blur

/** The number of panes of each row of the sheet, by the names of the stills. @type {Map<string, number> | null} */
let known = null;

/** @param {string} selector */
const imageOf = (selector) => /** @type {HTMLImageElement | null} */ (document.querySelector(selector));

/** @param {HTMLImageElement} sheet */
function stillsOf(sheet) {
  const entries = (sheet.dataset.panes ?? '').split(' ').map((entry) => entry.split(':'));
  return new Map(entries.map(([name, panes]) => [name, Number(panes)]));
}

/**
 * The panes of a view's still in the image that contains it; null if the page has none.
 * @param {DOMStringMap} view `still`: the name of its still; `pane`: the one that it shows, if not all.
 */
export function findStill({ still = '', pane }) {
  if (still === 'poster') {
    const poster = imageOf('#instead img');
    return poster && { image: poster, rows: 1, row: 0, columns: 1, first: 0, panes: 1 };
  }
  const image = imageOf('#stills');
  if (!image) return null;
  known ??= stillsOf(image);
  const columns = known.get(still);
  if (!columns) return null;
  const shown = pane === undefined ? { first: 0, panes: columns } : { first: Number(pane), panes: 1 };
  return { image, rows: known.size, row: [...known.keys()].indexOf(still), columns, ...shown };
}

/**
 * Draws a still as the view would: the shorter side of each pane fits the view's, and its edges are extended.
 * @param {CanvasRenderingContext2D} context @param {NonNullable<ReturnType<typeof findStill>>} still
 */
export function drawStill(context, { image, rows, row, columns, first, panes }) {
  const { width, height } = context.canvas,
    [paneWidth, paneHeight] = [image.naturalWidth / columns, image.naturalHeight / rows];
  const [sourceWidth, sourceHeight] = [paneWidth - 2 * edge, paneHeight - 2 * edge];
  for (let i = 0; i < panes; ++i) {
    const begin = Math.round((i * width) / panes),
      end = Math.round(((i + 1) * width) / panes),
      scale = Math.min(end - begin, height) / Math.min(paneWidth, paneHeight),
      [wide, high] = [scale * sourceWidth, scale * sourceHeight],
      [left, top] = [(begin + end - wide) / 2, (height - high) / 2],
      [x, y] = [(first + i) * paneWidth + edge, row * paneHeight + edge];
    const [right, bottom] = [left + wide, top + high];
    context.save();
    context.beginPath();
    context.rect(begin, 0, end - begin, height);
    context.clip();
    if (left > begin) {
      context.drawImage(image, x, y, 1, sourceHeight, begin, top, left - begin + 1, high);
      context.drawImage(image, x + sourceWidth - 1, y, 1, sourceHeight, right - 1, top, end - right + 1, high);
    }
    if (top > 0) {
      context.drawImage(image, x, y, sourceWidth, 1, left, 0, wide, top + 1);
      context.drawImage(image, x, y + sourceHeight - 1, sourceWidth, 1, left, bottom - 1, wide, top + 1);
    }
    context.drawImage(image, x, y, sourceWidth, sourceHeight, left, top, wide, high);
    context.restore();
  }
}
