#pragma once

#include "figure/gnuplot.h"
#include "study/study.h"

namespace twrench {

/// Three diagrams: the error over the step (the order), the error over the CPU time (work and
/// precision), and the energy drift in time, each method at the middle of its ladder.
Figure study_figure(const Study& study);

}  // namespace twrench
