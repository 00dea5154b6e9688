// A canvas for curves, as sharp as the display, with the theme's colours.
import { superscript } from '../words/words.js';

export class Chart {
  /** @param {HTMLElement} box Contains a canvas. @param {() => void} changed */
  constructor(box, changed) {
    this.canvas = /** @type {HTMLCanvasElement} */ (box.querySelector('canvas'));
    this.context = /** @type {CanvasRenderingContext2D} */ (this.canvas.getContext('2d'));
    /** The scale of lines and text: 1 if text has the usual size. */
    this.unit = 1;
    new ResizeObserver(() => {
      const ratio = devicePixelRatio;
      this.canvas.width = Math.max(1, Math.round(box.clientWidth * ratio));
      this.canvas.height = Math.max(1, Math.round(box.clientHeight * ratio));
      this.resized = true;
      this.unit = parseFloat(getComputedStyle(document.documentElement).fontSize) / 15;
      changed();
    }).observe(box);
  }

  /** Clears the canvas and sets its unit to CSS pixels. */
  begin() {
    const { context, canvas } = this;
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, canvas.width, canvas.height);
    context.scale(devicePixelRatio, devicePixelRatio);
    context.lineJoin = 'round';
    context.font = `${this.fontSize}px system-ui, "DejaVu Sans", sans-serif`;
    return context;
  }

  /**
   * Draws a line through points.
   * @param {string} color @param {number} width @param {Iterable<number[]>} points @param {number[]} [dashes]
   */
  line(color, width, points, dashes = []) {
    const { context } = this;
    context.strokeStyle = color;
    context.lineWidth = width;
    context.setLineDash(dashes);
    context.beginPath();
    for (const [x, y] of points) context.lineTo(x, y);
    context.stroke();
    context.setLineDash([]);
  }

  /** Draws a disc with a rim. @param {number} x @param {number} y @param {number} radius @param {string} color @param {string} rim */
  disc(x, y, radius, color, rim) {
    const { context } = this;
    context.beginPath();
    context.arc(x, y, radius, 0, 2 * Math.PI);
    context.fillStyle = color;
    context.fill();
    context.strokeStyle = rim;
    context.stroke();
  }

  get fontSize() {
    return 12 * this.unit;
  }

  /** Whether the chart is displayed; in full screen some are not. */
  get isShown() {
    return this.canvas.offsetParent !== null;
  }

  get width() {
    return this.canvas.width / devicePixelRatio;
  }

  get height() {
    return this.canvas.height / devicePixelRatio;
  }
}

/**
 * A step of 1, 2 or 5 times a power of ten that divides a span into about `count` parts.
 * @param {number} span @param {number} count
 */
export function tickStep(span, count) {
  const rough = span / Math.max(count, 1),
    power = 10 ** Math.floor(Math.log10(rough));
  return power * ([1, 2, 5].find((factor) => factor * power >= rough) ?? 10);
}

/** The time at a tick, without needless digits: 20, 0.05, 4·10⁸. @param {number} t @param {number} step */
export function tickText(t, step) {
  if (step < 1e6) return t.toFixed(Math.max(0, -Math.floor(Math.log10(step) + 1e-9)));
  if (t === 0) return '0';
  const power = Math.floor(Math.log10(t) + 1e-12);
  return `${Number((t / 10 ** power).toPrecision(6))}·10${superscript(power)}`;
}
