// Poinsot's construction: the inertia ellipsoid rolls without slipping on the invariable plane. See
// src/picture/views/poinsot_view.h; lengths are in units of the plane's distance, and L points up.
import {
  column,
  diagonal,
  frameWithZAlong,
  fromColumns,
  identity,
  inverse,
  product,
  scale,
  times,
  transposed,
} from '../math/linear.js';
import { directionOf, fitted, frameSphere } from '../math/camera.js';
import { DrawList } from '../picture/draw_list.js';
import { DrawListPass } from '../picture/draw_list_pass.js';
import { CanvasView, pixelsOfUnit } from './canvas_view.js';
import { shown } from './glass.js';
import { addArrow } from '../picture/arrows.js';
import { addDot, addLine, addLineOnHalo } from '../picture/lines.js';
import { addDisc, addEllipsoid } from '../picture/surfaces.js';

/** @typedef {import("../app/motion_model.js").MotionModel} MotionModel */
/** @typedef {import("../core/core.js").Sample} Sample */

const elevation = 0.6,
  fieldOfView = 0.5,
  momentumEnd = 1.34,
  leastPlane = 0.95,
  curvePoints = 120;

/** A rotation after which the momentum points up. @param {MotionModel} model */
function viewFromSpace({ atRest, up }) {
  if (atRest) return identity;
  const frame = frameWithZAlong(up);
  return transposed(fromColumns(column(frame, 1), column(frame, 2), column(frame, 0)));
}

/** The radii of the ellipsoid, least moment first. @param {MotionModel} model */
function radiiOf({ atRest, momentum, principal, facts }) {
  const radii = principal.moments.map((moment) => 1 / Math.sqrt(moment));
  const unit = atRest ? 1 / Math.max(...radii) : momentum / Math.sqrt(2 * facts.energy);
  return radii.map((radius) => radius * unit);
}

export class PoinsotView extends CanvasView {
  /** @param {HTMLElement} box @param {() => void} changed @param {number} azimuth of the scene's camera */
  constructor(box, changed, azimuth) {
    super(box, changed);
    this.home = { azimuth, elevation };
    this.opaque = new DrawList();
    this.translucent = new DrawList();
    /** @type {MotionModel | null} */
    this.model = null;
    this.viewFromSpace = identity;
    this.radii = [1, 1, 1];
    this.planeRadius = leastPlane;
    this.restore();
  }

  restore() {
    this.pass = new DrawListPass(this.gl);
  }

  /** @param {MotionModel} model */
  #prepare(model) {
    if (this.model === model) return;
    this.model = model;
    this.viewFromSpace = viewFromSpace(model);
    this.radii = radiiOf(model);
    this.planeRadius = Math.max(1.25 * model.annulus.outer, leastPlane);
  }

  camera() {
    const { radii, planeRadius } = this;
    /** @type {number[][]} */
    const points = [[0, 1.1 * momentumEnd, 0]];
    for (let i = 0; i < 24; ++i) {
      const angle = (2 * Math.PI * i) / 24;
      points.push([planeRadius * Math.sin(angle), 1, planeRadius * Math.cos(angle)]);
    }
    const framing = {
      fieldOfView,
      aspect: this.aspect,
      radius: Math.max(...radii),
      distance: 1,
      centre: [0, 0],
    };
    const fit = fitted(
      framing,
      [directionOf(this.home.azimuth, this.home.elevation)],
      this.model?.atRest ? [] : points,
    );
    const { zoom } = this.view;
    return frameSphere(
      { ...fit, distance: fit.distance / zoom, centre: fit.centre.map((x) => x * zoom) },
      this.direction(),
    );
  }

  /** @param {Sample} sample */
  #contact({ X, omega }) {
    return scale(1 / (this.model?.height ?? 1), times(this.viewFromSpace, times(X, omega)));
  }

  /** @param {{model: MotionModel, trail: Sample[], herpolhode: Sample[], colors: any}} picture */
  draw({ model, trail, herpolhode, colors }) {
    const { gl, canvas, opaque, translucent, pass } = this;
    if (gl.isContextLost() || !pass) return;
    this.#prepare(model);
    const camera = this.camera(),
      now = trail[trail.length - 1];
    gl.viewport(0, 0, canvas.width, canvas.height);
    gl.clearColor(colors.panel[0] / 255, colors.panel[1] / 255, colors.panel[2] / 255, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    opaque.begin(camera, canvas.width, canvas.height, pixelsOfUnit());
    translucent.begin(camera, canvas.width, canvas.height, pixelsOfUnit());
    const fromUnit = product(
      product(this.viewFromSpace, now.X),
      product(model.principal.axes, diagonal(this.radii)),
    );
    const ground = { color: colors.panel, opacity: colors.panel_opacity };
    if (!model.atRest) addDisc(translucent, [0, 1, 0], [0, 1, 0], this.planeRadius, ground, ground);
    addEllipsoid(translucent, fromUnit, { color: colors.plane, opacity: 0.4 }, 0.9, ground);
    this.#addGrid(fromUnit, colors);
    if (!model.atRest) {
      this.#addPolhode(model, now.X, colors);
      addArrow(opaque, [0, 0, 0], [0, momentumEnd, 0], 0.022, colors.momentum);
      addArrow(opaque, [0, 0, 0], this.#contact(now), 0.018, colors.omega);
      this.#addPlane(model, trail, herpolhode, colors);
    }
    pass.drawOpaque(opaque);
    pass.drawTranslucent(translucent);
    const labels = model.atRest
      ? []
      : [
          { text: 'L', tip: [0, momentumEnd, 0], color: colors.momentum },
          { text: 'ω', tip: this.#contact(now), color: colors.omega },
        ];
    this.hideNames(this.showNames(labels, camera));
  }

  /** A graticule about the axis of least moment, which makes the rolling visible. @param {number[]} fromUnit @param {any} colors */
  #addGrid(fromUnit, colors) {
    const list = this.translucent,
      normalFromUnit = transposed(inverse(fromUnit)),
      step = Math.PI / 12;
    const line = (/** @type {(k: number) => number[]} */ unitAt, /** @type {number} */ opacity) => {
      const points = [];
      for (let k = 0; k <= curvePoints; k += 2) {
        const unit = unitAt((2 * Math.PI * k) / curvePoints),
          place = times(fromUnit, unit);
        const visible = shown(place, times(normalFromUnit, unit), list.eye);
        points.push({ place, width: list.hairline, ink: { color: colors.dim, opacity: opacity * visible } });
      }
      addLine(list, points);
    };
    const unit = (/** @type {number} */ latitude, /** @type {number} */ longitude) => [
      Math.sin(latitude),
      Math.cos(latitude) * Math.cos(longitude),
      Math.cos(latitude) * Math.sin(longitude),
    ];
    for (let i = 0; i < 12; ++i) line((angle) => unit(angle, i * step), i % 6 === 0 ? 0.75 : 0.3);
    for (let i = -5; i <= 5; ++i) line((angle) => unit(i * step, angle), i === 0 ? 0.75 : 0.3);
  }

  /** @param {MotionModel} model @param {number[]} X @param {any} colors */
  #addPolhode(model, X, colors) {
    if (!model.level) return;
    const list = this.translucent,
      turned = product(this.viewFromSpace, X);
    const line = model.level.map((mu) => {
      const place = scale(1 / model.height, times(turned, model.omegaOf(mu)));
      return {
        place,
        width: 2 * list.hairline,
        ink: { color: colors.omega, opacity: shown(place, times(turned, mu), list.eye) },
      };
    });
    line.push(line[0]);
    addLineOnHalo(list, line, colors.panel);
  }

  /** @param {number} radius @param {number} width @param {number[]} color @param {number} opacity */
  #addRing(radius, width, color, opacity) {
    const points = [];
    for (let i = 0; i <= curvePoints; ++i) {
      const angle = (2 * Math.PI * i) / curvePoints;
      points.push({
        place: [radius * Math.sin(angle), 1, radius * Math.cos(angle)],
        width: width * this.translucent.hairline,
        ink: { color, opacity },
      });
    }
    addLine(this.translucent, points);
  }

  /** @param {MotionModel} model @param {Sample[]} trail @param {Sample[]} herpolhode @param {any} colors */
  #addPlane(model, trail, herpolhode, colors) {
    const list = this.translucent,
      hairline = list.hairline,
      up = [0, 1, 0];
    addDisc(
      list,
      up,
      up,
      this.planeRadius,
      { color: colors.plane, opacity: 0.36 },
      { color: colors.plane, opacity: 0.22 },
    );
    this.#addRing(this.planeRadius, 1.2, colors.plane, 0.9);
    for (const radius of [model.annulus.inner, model.annulus.outer]) {
      if (radius > 0.01) this.#addRing(radius, 1, colors.dim, 0.45);
    }
    addLine(
      list,
      herpolhode.map((sample) => ({
        place: this.#contact(sample),
        width: hairline,
        ink: { color: colors.omega, opacity: 0.35 },
      })),
    );
    const now = trail[trail.length - 1];
    addLine(
      list,
      trail.map((sample) => {
        const age = Math.min(Math.max((now.t - sample.t) / model.trailLength, 0), 1);
        return {
          place: this.#contact(sample),
          width: (3 - 1.6 * age) * hairline,
          ink: { color: colors.omega, opacity: (1 - age) ** 1.2 },
        };
      }),
    );
    addDot(list, this.#contact(now), 4.6 * hairline, { color: colors.panel, opacity: 0.9 });
    addDot(list, this.#contact(now), 3.4 * hairline, { color: colors.omega, opacity: 1 });
  }
}
