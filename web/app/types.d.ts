// The state of the page, and the data that the program writes into it.

import type { RecordedRows } from '../core/types';

export type FrameName = 'space' | 'body' | 'rotating';
export type Comparison = 'off' | 'beside' | 'ghost';

export interface State {
  t: number; // Time of the motion, s.
  speed: number; // Seconds of motion per second.
  omega: number[]; // At t = 0, body axes, rad/s.
  moments: number[] | null; // Of the body's x, y and z axes, g cm^2; null for the scene's body.
  wheel: number[]; // Angular momentum of a wheel relative to the body, body axes, g cm^2/s.
  energy_loss_time: number; // s; Infinity if no energy is lost.
  theme: string; // One of the page's data, or `auto`.
  frame: FrameName;
  show: string[]; // The items shown around the body.
  view: number[]; // Azimuth and elevation from the scene's camera, rad, and zoom.
  from: number; // Start of the timeline, s.
  length: number; // Of the timeline, s.
  compare: Comparison;
  methods: string[]; // The two compared methods.
  step: number; // s
  tolerance: number;
  lang: 'en' | 'nb';
}

export interface SurfacePart {
  side_begin: number; // Index at which the side of a cylinder begins; otherwise `end`.
  end: number;
  tint?: number[]; // The mean colour of its vertices, if they have colours.
  material: number; // Index in the materials of a theme.
}

export interface Surface {
  vertices: Float32Array; // Positions in body axes, cm, each with its normal.
  indices: Uint32Array;
  colors: Uint16Array | null; // Linear colours of the vertices, if any part has them.
  parts: SurfacePart[];
  mark?: number[]; // The uniform mark_from_body of marked.vert, for a body that has a mark.
  radius: number; // Bounding radius, cm.
  trail_point: number[]; // The point of the body that draws the trail.
  occluder_count: number; // The most occluders of a part.
  model: number[]; // The numbers from which the core computes uniforms.
}

/** The data that `twrench page` writes into the page: see src/page/page_json.h. */
export interface PageData {
  source?: string; // the argument for the scene on the command line
  source_options?: string[]; // options that belong to it, if it is a mesh
  scene: Record<string, any>; // its values, with the keys of scene files
  source_scene?: Record<string, any>; // its values before the command line changed them, if it did
  inertia: number[]; // body axes, g cm^2, row by row
  attitude?: number[]; // of the scene's motion at t = 0, row by row; default: the identity
  recording?: RecordedRows & { options: string[] }; // a recorded motion, and the options that show it in a film
  surface: Surface;
  themes: Record<string, any>;
  rigid_features: string[]; // items of a film that have a meaning only for a rigid body
  lossless_features: string[]; // and only if no energy is lost
  language?: State['lang']; // of the page; default: the reader's
  article: boolean; // whether the article is above the lab
  time_units: [number, number, string][]; // The longest first: the shortest time written in it, its length in s, its symbol.
  limits: {
    moment: number[];
    moment_ratio: number;
    omega: number[];
    wheel: number[];
    energy_loss_time: number[];
    step: number[];
    tolerance: number[];
    time: number[];
  };
}
