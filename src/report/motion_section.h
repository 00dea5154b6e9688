#pragma once

#include "report/document.h"
#include "report/results.h"

namespace twrench::report {

/// Returns the motion of an experiment: its constants, the nine components of X against time, its
/// flips as predicted and as the scene's method has them, and how far the method drifts. Throws
/// MotionError where the method cannot compute it.
Section motion_section(const Experiment& experiment);

}  // namespace twrench::report
