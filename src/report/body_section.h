#pragma once

#include "report/document.h"
#include "report/results.h"

namespace twrench::report {

/// Returns the mass properties of a body, and what becomes of a small tilt about each axis.
Section body_section(const Experiment& experiment);

}  // namespace twrench::report
