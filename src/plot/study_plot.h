#pragma once

#include <twrench/study/study.h>

#include "plot/gnuplot.h"

namespace twrench::plot {

/// Returns three diagrams: error against step size (order), error against CPU time
/// (work-precision), and energy drift against time, each method at the middle of its ladder.
Plot study_plot(const study::Study& study);

}  // namespace twrench::plot
