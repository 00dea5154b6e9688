// What is shown in space around the body: its axes, L and omega, the invariable plane and the trail
// of a point. See src/picture/overlay/body_overlay.h for why omega's arrow has this length.
import { add, column, frameWithZAlong, normalized, scale, subtract, times } from '../math/linear.js';
import { addArrow } from '../picture/arrows.js';
import { addDot, addLine, addLineOnHalo, haloOf } from '../picture/lines.js';
import { addDisc } from '../picture/surfaces.js';

/** @typedef {import("../app/motion_model.js").MotionModel} MotionModel */
/** @typedef {import("../core/core.js").Sample} Sample */
/** @typedef {import("../picture/draw_list.js").DrawList} DrawList */
/** @typedef {Record<string, boolean>} Shown */

// As multiples of the bounding radius.
const planeDistance = 1.18,
  longestOmega = 1.5,
  leastPlane = 0.85,
  axisLength = 1.16,
  momentumLength = 1.42;
const momentumShaft = 0.017,
  omegaShaft = 0.015,
  axisShaft = 0.01,
  trailWidth = 0.016,
  planeLine = 0.004;

/** @param {number[]} centre @param {number[]} normal @param {number} radius @param {number} count */
function circle(centre, normal, radius, count) {
  const frame = frameWithZAlong(normal);
  const points = [];
  for (let i = 0; i <= count; ++i) {
    const angle = (2 * Math.PI * i) / count;
    points.push(add(centre, scale(radius, times(frame, [Math.cos(angle), Math.sin(angle), 0]))));
  }
  return points;
}

export class BodyOverlay {
  /**
   * @param {MotionModel} model @param {import("../picture/surface.js").Surface} surface
   * @param {any} colors of the theme's overlay
   */
  constructor(model, surface, colors) {
    this.model = model;
    this.surface = surface;
    this.colors = colors;
    const { radius } = surface;
    this.radius = radius;
    const longest = Math.max(model.height * Math.hypot(1, model.annulus.outer), Math.hypot(...model.omega));
    this.scale = model.atRest ? 0 : radius * Math.min(planeDistance / model.height, longestOmega / longest);
    this.planeHeight = this.scale * model.height;
    this.omegaRadius = model.annulus.outer * this.planeHeight;
    this.planeRadius = Math.max(1.2 * this.omegaRadius, leastPlane * radius);
    this.momentumTip = scale(momentumLength * radius, model.up);
  }

  /** @param {Shown} shown */
  boundingRadius(shown) {
    return shown.axes ? axisLength * this.radius : this.radius;
  }

  /** Points that a camera should have in view at all times, in space, cm. @param {Shown} shown */
  extent(shown) {
    if (this.model.atRest) return [];
    const points = shown.momentum ? [this.momentumTip] : [];
    if (shown.omega || shown.plane) {
      const across = shown.plane ? this.planeRadius : this.omegaRadius;
      points.push(...circle(scale(this.planeHeight, this.model.up), this.model.up, across, 16));
    }
    return points;
  }

  /** @param {Sample} sample */
  omegaTip(sample) {
    return scale(this.scale, times(sample.X, sample.omega));
  }

  /** @param {Shown} shown @param {Sample} sample @param {DrawList} opaque */
  drawArrows(shown, sample, opaque) {
    const { radius, colors } = this;
    if (shown.axes) {
      for (let i = 0; i < 3; ++i) {
        addArrow(
          opaque,
          [0, 0, 0],
          scale(axisLength * radius, column(sample.X, i)),
          axisShaft * radius,
          colors.axis[i],
        );
      }
    }
    if (this.model.atRest) return;
    if (shown.momentum)
      addArrow(opaque, [0, 0, 0], this.momentumTip, momentumShaft * radius, colors.momentum);
    if (shown.omega) addArrow(opaque, [0, 0, 0], this.omegaTip(sample), omegaShaft * radius, colors.omega);
  }

  /** @param {Shown} shown @param {Sample[]} trail Oldest first, ending now. @param {DrawList} list */
  drawTranslucent(shown, trail, list) {
    if (shown.plane && !this.model.atRest) this.#drawPlane(list);
    if (!shown.trail || trail.length === 0) return;
    if (shown.plane && shown.omega) {
      this.#drawTrack(trail, 0.6 * trailWidth, this.colors.omega, (sample) => this.omegaTip(sample), list);
    }
    this.#drawTrack(
      trail,
      trailWidth,
      this.colors.trail,
      (sample) => times(sample.X, this.surface.trail_point),
      list,
    );
  }

  /** @param {DrawList} list */
  #drawPlane(list) {
    const { up } = this.model;
    const centre = scale(this.planeHeight, up),
      color = this.colors.plane;
    addDisc(list, centre, up, this.planeRadius, { color, opacity: 0.22 }, { color, opacity: 0.1 });
    const point = (/** @type {number[]} */ place, /** @type {number} */ opacity) => ({
      place,
      width: planeLine * this.radius * list.pixels(place),
      ink: { color, opacity },
    });
    for (let ring = 1; ring <= 4; ++ring) {
      addLine(
        list,
        circle(centre, up, (this.planeRadius * ring) / 4, 96).map((place) =>
          point(place, ring === 4 ? 0.75 : 0.4),
        ),
      );
    }
    for (const rim of circle(centre, up, this.planeRadius, 12)) {
      addLine(
        list,
        [0.25, 0.5, 0.75, 1].map((share) => point(add(centre, scale(share, subtract(rim, centre))), 0.3)),
      );
    }
  }

  /**
   * The line that a point leaves behind, with a dot where it is now.
   * @param {Sample[]} trail @param {number} width @param {number[]} color
   * @param {(sample: Sample) => number[]} place @param {DrawList} list
   */
  #drawTrack(trail, width, color, place, list) {
    const now = trail[trail.length - 1];
    const line = trail.map((sample) => {
      const age = Math.min(Math.max((now.t - sample.t) / this.model.trailLength, 0), 1);
      const point = place(sample);
      return {
        place: point,
        width: width * this.radius * (1 - 0.6 * age) * list.pixels(point),
        ink: { color, opacity: 0.9 * (1 - age) ** 1.4 },
      };
    });
    addLineOnHalo(list, line, this.colors.panel);
    const last = line[line.length - 1];
    const near = add(
      last.place,
      scale(1.15 * width * this.radius, normalized(subtract(list.eye, last.place))),
    );
    addDot(list, near, 1.15 * last.width + haloOf(last.width), { color: this.colors.panel, opacity: 0.9 });
    addDot(list, near, 1.15 * last.width, { color, opacity: 1 });
  }

  /** @param {Shown} shown @param {Sample} sample @returns {import("./canvas_view.js").Label[]} */
  labels(shown, sample) {
    if (!shown.labels) return [];
    const labels = [];
    for (let i = 0; shown.axes && i < 3; ++i) {
      labels.push({
        text: 'xyz'[i],
        tip: scale(axisLength * this.radius, column(sample.X, i)),
        color: this.colors.axis[i],
      });
    }
    if (this.model.atRest) return labels;
    if (shown.momentum) labels.push({ text: 'L', tip: this.momentumTip, color: this.colors.momentum });
    if (shown.omega) labels.push({ text: 'ω', tip: this.omegaTip(sample), color: this.colors.omega });
    return labels;
  }
}
