// The sections of the article (article.json).
import type { Comparison, FrameName } from '../app/types';
export type AxisName = 'least' | 'middle' | 'greatest';
export type ControlName = 'time' | 'sceneTime' | 'push' | 'axis' | 'lean' | 'start' | 'delay' | 'step' | 'wheel';

/**
 * The texts of a section. In them {name} is a number of numbers.js, and [thing|words] are words in the colour
 * of the thing in the figure.
 */
export interface SectionText {
  title: string;
  text: string[];
  caption: string;
  readout: string;
}

export interface FigureDescription {
  spin: AxisName[]; // The axes about which bodies spin side by side.
  names?: string[]; // The keys of the words for the bodies; default: their axes.
  push?: number; // Deviation from the axis, as a fraction of the angular velocity.
  value?: number; // The control's at the start: for a step the rotation in rad, for a wheel a multiple of the threshold; default: the push.
  show: string[]; // As in the page's state, and so are the next three.
  frame?: FrameName;
  compare?: Comparison;
  methods?: string[];
  flips: number; // The length of the timeline, in intervals between flips; 0: until after the first flip.
  flipSeconds: number; // Duration of an interval on the screen, s.
  control: ControlName; // What the reader drags.
  loops?: boolean; // Whether it starts again at the end of the timeline.
  sphere?: boolean; // Whether the momentum sphere is beside the body.
  bars?: boolean; // Whether bars of the tug-of-war are below the body.
  chart?: boolean; // Whether a chart of the lean is below the body.
}

export interface Section {
  id: string;
  when?: 'replaced' | 'recorded'; // Shows the scene's motion: if the other figures show a box instead, or beside a recorded motion.
  figure: FigureDescription;
  formula?: { math: string; text: string }; // MathML, and text for browsers without it.
  en: SectionText;
  nb: SectionText;
}
