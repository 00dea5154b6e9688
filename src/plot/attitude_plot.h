#pragma once

#include <twrench/motion/free_body.h>

#include <span>
#include <string>
#include <vector>

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

}  // namespace twrench::plot
