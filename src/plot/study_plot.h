#pragma once

#include <twrench/study/study.h>

#include "plot/gnuplot.h"

namespace twrench::plot {

/// Returns four diagrams: error against step size (order), against CPU time (work-precision) and
/// against energy drift, and energy drift against time, each method at the middle of its ladder.
Plot study_plot(const study::Study& study);

}  // namespace twrench::plot
