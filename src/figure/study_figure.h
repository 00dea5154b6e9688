#pragma once

#include "figure/gnuplot.h"
#include "study/study.h"

namespace twrench {

/// Returns three diagrams: error against step size (order), error against CPU time
/// (work-precision), and energy drift against time, each method at the middle of its ladder.
Figure study_figure(const Study& study);

}  // namespace twrench
