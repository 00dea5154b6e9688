// The momentum in the body frame, on a sphere because its length is constant:
// src/picture/views/momentum_view.cpp. The start of the motion can be dragged.
import {
  column,
  dot,
  fromColumns,
  cross,
  identity,
  normalized,
  scale,
  subtract,
  times,
  transposed,
} from '../math/linear.js';
import { clipFromSpace, directionOf, fitted, frameSphere, pickSphere, transformed } from '../math/camera.js';
import { DrawList } from '../picture/draw_list.js';
import { DrawListPass } from '../picture/draw_list_pass.js';
import { CanvasView, pixelsOfUnit } from './canvas_view.js';
import { shown } from './glass.js';
import { addArrow } from '../picture/arrows.js';
import { addDot, addLine, addLineOnHalo } from '../picture/lines.js';
import { addEllipsoid } from '../picture/surfaces.js';

/** @typedef {import("../app/motion_model.js").MotionModel} MotionModel */
/** @typedef {import("../core/core.js").Sample} Sample */

const lifted = 1.002; // lifts curves off the facets of the sphere
const axisEnd = 1.24,
  named = 1.12,
  fieldOfView = 0.5;

/**
 * What the view shows: paths of directions of the momentum, body axes, each oldest first and with its
 * times; the second is that of the method it is compared with.
 * @typedef {{model: MotionModel, trails: Sample[][], colors: any}} SpherePicture
 */

export class SphereView extends CanvasView {
  /** @param {HTMLElement} box @param {() => void} changed */
  constructor(box, changed) {
    super(box, changed);
    this.opaque = new DrawList();
    this.translucent = new DrawList();
    /** @type {MotionModel | null} */
    this.model = null;
    this.viewFromBody = identity;
    this.facing = '';
    this.restore();
  }

  restore() {
    this.pass = new DrawListPass(this.gl);
  }

  /**
   * Chooses the side from which a motion is seen, once for a body: the view would jump while the
   * start is dragged.
   * @param {MotionModel} model
   */
  #face(model) {
    if (this.model === model) return;
    const { axes } = model.principal;
    const key = axes.join() + model.principal.names.join();
    this.viewFromBody = transposed(
      fromColumns(cross(column(axes, 0), column(axes, 1)), column(axes, 0), column(axes, 1)),
    );
    if (key !== this.facing) {
      const mu = times(transposed(axes), model.up);
      const from = times(
        this.viewFromBody,
        times(axes, [mu[0] < 0 ? -0.36 : 0.36, mu[1] < 0 ? -0.8 : 0.8, mu[2] < 0 ? -0.5 : 0.5]),
      );
      this.home = {
        azimuth: Math.atan2(from[0], from[2]),
        elevation: Math.atan2(from[1], Math.hypot(from[0], from[2])),
      };
      this.facing = key;
    }
    this.model = model;
  }

  camera() {
    const tips = [0, 1, 2].map((i) => scale(named * axisEnd, this.#axis(i)));
    const framing = { fieldOfView, aspect: this.aspect, radius: 1, distance: 1, centre: [0, 0] };
    const fit = fitted(framing, [directionOf(this.home.azimuth, this.home.elevation)], tips);
    const { zoom } = this.view;
    return frameSphere(
      { ...fit, distance: fit.distance / zoom, centre: fit.centre.map((x) => x * zoom) },
      this.direction(),
    );
  }

  /** The principal axis with that index in the view's coordinates. @param {number} i */
  #axis(i) {
    if (!this.model) return column(identity, i);
    return times(this.viewFromBody, column(this.model.principal.axes, i));
  }

  /** @param {SpherePicture} picture */
  draw({ model, trails, colors }) {
    const { gl, canvas, opaque, translucent, pass } = this;
    if (gl.isContextLost() || !pass) return;
    this.#face(model);
    const camera = this.camera();
    this.colors = colors;
    gl.viewport(0, 0, canvas.width, canvas.height);
    gl.clearColor(colors.panel[0] / 255, colors.panel[1] / 255, colors.panel[2] / 255, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    opaque.begin(camera, canvas.width, canvas.height, pixelsOfUnit());
    translucent.begin(camera, canvas.width, canvas.height, pixelsOfUnit());
    this.#addSphere(model, colors);
    trails.slice(1).forEach((trail) => this.#addMomentum(model, trail, colors.omega, colors));
    if (!model.atRest && trails[0]) this.#addMomentum(model, trails[0], colors.momentum, colors);
    if (!model.atRest) this.#addStart(model, colors);
    pass.drawOpaque(opaque);
    pass.drawTranslucent(translucent);
    this.#nameAll(model, trails, colors, camera);
  }

  /** @param {MotionModel} model @param {Sample[][]} trails @param {any} colors @param {import("../math/camera.js").Camera} camera */
  #nameAll(model, trails, colors, camera) {
    const labels = [0, 1, 2].map((i) => ({
      text: model.principal.names[i],
      tip: scale(axisEnd, this.#axis(i)),
      color: colors.axis[model.principal.colors[i]],
    }));
    for (const [i, trail] of model.atRest ? [] : trails.entries()) {
      const tip = this.#place(model.muOf(trail[trail.length - 1].omega));
      const text = trails.length > 1 ? 'AB'[i] : 'L';
      labels.push({ text, tip, color: i === 0 ? colors.momentum : colors.omega });
    }
    this.hideNames(this.showNames(labels, camera));
  }

  /** @param {ArrayLike<number>} mu body axes */
  #place(mu) {
    return times(this.viewFromBody, mu);
  }

  /** @param {number[][]} curve body axes @param {number} width in hairlines @param {number[]} color @param {number} opacity */
  #addCurve(curve, width, color, opacity) {
    const list = this.translucent;
    const line = curve.map((mu) => {
      const place = this.#place(mu);
      return {
        place: scale(lifted, place),
        width: width * list.hairline,
        ink: { color, opacity: opacity * shown(place, place, list.eye) },
      };
    });
    line.push(line[0]);
    addLine(list, line);
  }

  /** @param {MotionModel} model @param {any} colors */
  #addSphere(model, colors) {
    const {
      names: { length },
      colors: own,
      axes,
    } = model.principal;
    for (let i = 0; i < length; ++i)
      addArrow(
        this.opaque,
        scale(0.98, this.#axis(i)),
        scale(axisEnd, this.#axis(i)),
        0.016,
        colors.axis[own[i]],
      );
    addEllipsoid(this.translucent, identity, { color: colors.plane, opacity: 0.22 }, 0.75, {
      color: colors.panel,
      opacity: colors.panel_opacity,
    });
    for (const curve of model.family) {
      const nearLeast = aboutLeast(curve, axes);
      this.#addCurve(curve, 1.25, colors.axis[own[nearLeast ? 0 : 2]], 0.95);
    }
    if (model.level) this.#addCurve(model.level, 1.5, colors.momentum, 0.85);
    for (const circle of model.separatrix) this.#addCurve(circle, 1.7, colors.text, 0.95);
  }

  /** @param {MotionModel} model @param {Sample[]} trail @param {number[]} color @param {any} colors */
  #addMomentum(model, trail, color, colors) {
    const list = this.translucent,
      hairline = list.hairline,
      eye = list.eye;
    const now = trail[trail.length - 1];
    const line = trail.map((sample) => {
      const age = Math.min(Math.max((now.t - sample.t) / model.trailLength, 0), 1);
      const place = scale(lifted, this.#place(model.muOf(sample.omega)));
      return {
        place,
        width: (3.2 - 2 * age) * hairline,
        ink: { color, opacity: (1 - age) ** 1.2 * shown(place, place, eye) },
      };
    });
    addLineOnHalo(list, line, colors.panel);
    const place = this.#place(model.muOf(now.omega));
    addLine(list, [
      { place: [0, 0, 0], width: hairline, ink: { color, opacity: 0.12 } },
      { place, width: 1.5 * hairline, ink: { color, opacity: 0.7 * shown(place, place, eye) } },
    ]);
    const clear = 0.45 + 0.55 * shown(place, place, eye);
    addDot(list, place, 5.2 * hairline, { color: colors.panel, opacity: 0.9 * clear });
    addDot(list, place, 4 * hairline, { color, opacity: clear });
  }

  /** The handle: a ring around where the motion starts. @param {MotionModel} model @param {any} colors */
  #addStart(model, colors) {
    const list = this.translucent,
      eye = list.eye;
    const place = this.#place(model.up),
      clear = 0.35 + 0.65 * shown(place, place, eye);
    const normal = normalized(subtract(eye, place));
    const unit = pixelsOfUnit();
    const radius = (7.5 * unit) / Math.max(list.pixels(place), 1);
    const right = normalized(cross([0, 1, 0], normal)),
      above = cross(normal, right);
    const ring = [];
    for (let i = 0; i <= 40; ++i) {
      const angle = (2 * Math.PI * i) / 40;
      ring.push(right.map((x, k) => place[k] + radius * (Math.cos(angle) * x + Math.sin(angle) * above[k])));
    }
    for (const [width, color] of /** @type {[number, number[]][]} */ ([
      [4.2, colors.panel],
      [2, colors.text],
    ])) {
      addLine(
        list,
        ring.map((at) => ({ place: at, width: width * unit, ink: { color, opacity: clear } })),
      );
    }
  }

  /** Whether a place in the picture is at the handle. @param {number[]} at -1 to 1 across and up */
  isAtStart([x, y]) {
    if (!this.model || this.model.atRest) return false;
    const clip = transformed(clipFromSpace(this.camera()), this.#place(this.model.up));
    const dx = ((clip[0] / clip[3] - x) * this.canvas.clientWidth) / 2,
      dy = ((clip[1] / clip[3] - y) * this.canvas.clientHeight) / 2;
    return Math.hypot(dx, dy) < 22;
  }

  /** The direction of the momentum, body axes, at a place in the picture. @param {number[]} at */
  muAt([x, y]) {
    return times(transposed(this.viewFromBody), pickSphere(this.camera(), x, y, 1));
  }

  /**
   * The start moved by angles across and up in the picture, rad.
   * @param {number} right @param {number} up
   */
  muMoved(right, up) {
    if (!this.model) return [1, 0, 0];
    const camera = this.camera();
    const place = this.#place(this.model.up);
    const moved = place.map((x, i) => x + right * camera.attitude[i] + up * camera.attitude[3 + i]);
    return times(transposed(this.viewFromBody), normalized(moved));
  }
}

/** Whether a curve circles the axis of least moment. @param {number[][]} curve @param {number[]} axes */
function aboutLeast(curve, axes) {
  const least = column(axes, 0);
  const first = Math.sign(dot(curve[0], least));
  return curve.every((mu) => dot(mu, least) * first > 0);
}
