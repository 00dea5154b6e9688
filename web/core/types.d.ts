// Arguments and results of the core. Units are cm, g, s and rad.

export type Vector = [number, number, number];
/** Nine numbers, row by row. */
export type Matrix = number[];
export type Kind = 'steady' | 'about_least' | 'about_greatest' | 'separatrix';

/** The motion at one time. */
export interface Sample {
  t: number; // s
  X: Matrix; // space_from_body
  omega: Vector; // in body axes, rad/s
}

/** The motion at many times; sample i has X[9 i ... 9 i + 8] and omega[3 i ... 3 i + 2]. */
export interface Samples {
  t: Float64Array; // s
  X: Float64Array;
  omega: Float64Array;
}

/** Deviations of samples from the conserved quantities and from the motion. */
export interface Diagnostics {
  energy: Float64Array; // 1/2 omega . (I omega), g cm^2/s^2
  energyDrift: Float64Array; // energy/energy(0) - 1; if energy is lost, the difference from that of the motion
  orthogonalityError: Float64Array; // |X^T X - Id|, Frobenius
  momentumError: Float64Array; // |X I omega - L| / |L|
  error: Float64Array; // |X - X of the motion|, Frobenius; sqrt(2) a if the angle a is small
}

export interface Method {
  name: string;
  order: number | null;
  exact: boolean; // has no step
  adaptive: boolean; // takes a tolerance and chooses its steps
  leavesGroup: boolean; // X does not remain a rotation
  conservesEnergy: boolean;
  reversible: boolean;
  summary: string; // one line
  source: string;
}

/** A recorded motion. */
export interface RecordedRows {
  file: string;
  rows: Float64Array; // Eight numbers each: the time in s, the attitude as the quaternion w, x, y, z, and omega.
  duration: number; // s
  longest_step: number; // s; if two rows are farther apart, nothing is known between them
  flips: number[]; // s
}

/** What moves in a body. */
export interface Interior {
  wheel: readonly number[]; // angular momentum of a wheel relative to the body, body axes, g cm^2/s
  energyLossTime: number; // time constant of the energy loss, s; Infinity if no energy is lost
}

/** Sign changes of omega along the intermediate axis, in closed form. */
export interface Flips {
  interval: number; // s; Infinity on the separatrix
  first: number; // s, after t = 0
  asymptoticInterval: number; // s, its approximation near the separatrix
  swing: number; // rad, the angle through which the intermediate axis swings
}

/** The rotation about L in one period of the momentum in the body: total = dynamic + geometric. */
export interface Phase {
  period: number; // s
  total: number; // rad, without mod 2 pi
  dynamic: number; // rad, 2 E T / |L|
  geometric: number; // rad, minus the area on the unit sphere
}

/** The properties of a motion that do not depend on time. */
export interface Facts {
  kind: Kind | null; // null without a closed form: the motion is then integrated
  longest: number; // the greatest t, s
  rate: number; // |omega| at t = 0; without a closed form an upper bound at all times, rad/s
  losesEnergy: boolean;
  momentum: Vector; // L in space axes, g cm^2/s; also the body momentum at t = 0
  energy: number; // 1/2 omega . (I omega), g cm^2/s^2
  moments: Vector; // principal moments, ascending, g cm^2
  axes: Matrix; // body_from_principal; column i is the axis of moments[i]
  flips: Flips | null; // null for a steady motion and a symmetric body, and without a closed form
  phase: Phase | null; // null for a steady motion and on the separatrix, and without a closed form
  turnsOver: boolean; // whether the body turns over instead of wobbling; false if energy is lost
  isReal: boolean; // whether a real body can have these moments (triangle inequality)
}

export interface StepControl {
  step: number; // s; of an adaptive method the first step
  tolerance: number; // of an adaptive method
}

/**
 * A part of a body, with the dimensions of its shape in cm under their keys in scene files. It cannot be a
 * mesh.
 */
export interface PartValues {
  shape: string;
  density: number; // g/cm^3
  position: Vector; // cm
  body_from_part: Matrix; // rotation
  name?: string;
}

/** A shape and the keys of its dimensions, each a number or a vector. */
export interface Shape {
  name: string;
  keys: string[];
}

export interface MassProperties {
  mass: number; // g
  centreOfMass: Vector; // cm
  inertia: Matrix; // about the centre of mass, body axes, g cm^2
  moments: Vector; // ascending, g cm^2
  axes: Matrix; // body_from_principal
}

/** The behaviour of a small tilt of a steady rotation. */
export interface Stability {
  kind: 'unstable' | 'stable' | 'neutral';
  rate: number; // 1/s of growth, or rad/s of the wobble
}

export type Part = PartValues & Record<string, any>;

/** The viewpoint of a view; angles in rad. */
export interface Viewpoint {
  azimuth: number;
  elevation: number;
  zoom: number;
}

/** Triangles as indices of vertices. */
export interface Triangles {
  faces: Uint32Array;
  edgeQuads: Uint32Array;
}

/** See src/picture/overlay/draw_list.h. */
export interface DrawList {
  vertices: Float32Array;
  items: Triangles;
  outlines: Triangles;
  ghosts: Triangles;
}

/** In pixels of the pane from its top left. */
export interface Label {
  text: string;
  anchor: number[];
  away: number[]; // direction in which there is room
  color: number[];
}

/** Matrices row by row, for column vectors in OpenGL's conventions. */
export interface Camera {
  attitude: number[]; // camera_from_space, 9 numbers
  distance: number; // From the origin to the eye, cm.
  projection: number[]; // clip_from_camera, 16 numbers
}

/**
 * The contents of a view. The lists are in the core's memory until the next view replaces them. Each use
 * of an array reads the memory again, because it moves when it grows.
 */
export interface Contents {
  camera: Camera;
  clipZNearer: number; // The change of z in clip space that brings an item nearer by the picture's height.
  opaque: DrawList;
  translucent: DrawList;
  labels: Label[];
}

/**
 * The properties of a picture, in addition to the motion and the viewpoint, as page_views.h describes
 * them. Features are by name.
 */
export interface Settings {
  theme: string;
  frame: string;
  show: readonly string[];
  stress: readonly string[];
  width: number;
  height: number;
  thinnest: number;
  azimuth: number;
  elevation: number;
  distance: number;
  fieldOfView: number;
  interval: number;
  radius: number;
  trailLength: number;
  trailX: number;
  trailY: number;
  trailZ: number;
  curveBegin: number;
  curveEnd: number;
}
