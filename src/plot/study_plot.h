#pragma once

#include <twrench/study/study.h>

#include "plot/gnuplot.h"
#include "scene/scene.h"

namespace twrench::plot {

/// Returns four diagrams: error against step size (order), against CPU time (work-precision) and
/// against energy drift, and energy drift against time, each method at the middle of its ladder.
/// `language` is that of the words.
Plot study_plot(const study::Study& study, scene::Language language = scene::Language::en);

}  // namespace twrench::plot
