#pragma once

#include "report/document.h"
#include "report/results.h"

namespace twrench::report {

/// Returns all methods on the motion of an experiment: measured orders, errors, drifts, flips and
/// work.
Section methods_section(const Experiment& experiment);

/// Returns the sources of the equations and of all methods.
Section references();

}  // namespace twrench::report
