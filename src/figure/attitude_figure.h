#pragma once

#include <span>
#include <string>
#include <vector>

#include "figure/gnuplot.h"
#include "motion/free_body.h"

namespace twrench {

/// A motion to draw.
struct AttitudeCurve {
  std::string title;
  std::vector<Sample> samples;  ///< in the order of time
  std::vector<double> flips;    ///< s, to be marked
};

/// The nine components of X against time, a panel each; the curves lie over one another, a colour
/// each. One curve at least.
Figure nine_panels(std::span<const AttitudeCurve> curves);

/// A panel for each column of X, its three components over one another; a row of panels for each
/// of the curves.
Figure column_panels(std::span<const AttitudeCurve> curves);

}  // namespace twrench
