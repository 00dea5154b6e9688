#pragma once

#include <twrench/motion/free_body.h>
#include <twrench/study/study.h>

#include <span>
#include <string>
#include <vector>

#include "check/verdict/judge.h"
#include "plot/gnuplot.h"
#include "scene/scene.h"

namespace twrench::plot {

/// A motion to plot.
struct AttitudeCurve {
  /// Name in the key of the plot.
  std::string title;
  /// Samples in order of time.
  std::vector<motion::Sample> samples;
  /// Times of the flips to mark, in s.
  std::vector<double> flips;
  /// Whether the line is dashed, so that one beneath it can be seen.
  bool is_dashed = false;
};

/// Returns the nine components of X against time, one panel each, with one colour per curve. There
/// must be at least one curve. `language` is that of the words beside a single curve.
Plot nine_panels(std::span<const AttitudeCurve> curves,
                 scene::Language language = scene::Language::en);

/// Returns one panel per column of X with its three components, and one row of panels per curve.
Plot column_panels(std::span<const AttitudeCurve> curves);

/// A judged trajectory to plot.
struct JudgedCurve {
  std::string title;                  ///< its name in the key
  const check::Judgement* judgement;  ///< not null
};

/// Returns the errors of rates and of attitudes against time on a logarithmic scale, with a panel
/// for each kind that is present. A dashed line shows the resolution limit of the digits. Rates are
/// in the unit of the first file. There must be at least one curve, and one row.
Plot check_plot(std::span<const JudgedCurve> curves);

/// Returns four diagrams: error against step size (order), against CPU time (work-precision) and
/// against energy drift, and energy drift against time, each method at the middle of its ladder.
/// `language` is that of the words.
Plot study_plot(const study::Study& study, scene::Language language = scene::Language::en);

}  // namespace twrench::plot
