#pragma once

#include <twrench/study/study.h>

#include "plot/gnuplot.h"

namespace twrench {

/// Returns three diagrams: error against step size (order), error against CPU time
/// (work-precision), and energy drift against time, each method at the middle of its ladder.
Plot study_plot(const Study& study);

}  // namespace twrench
