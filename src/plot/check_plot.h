#pragma once

#include <span>
#include <string>

#include "check/verdict/judge.h"
#include "plot/gnuplot.h"

namespace twrench::plot {

/// A judged trajectory to plot.
struct JudgedCurve {
  std::string title;                  ///< its name in the key
  const check::Judgement* judgement;  ///< not null
};

/// Returns the errors of rates and of attitudes against time, a panel for each kind that there is,
/// on a logarithmic scale; beside each, dashed, the resolution limit of its digits.
/// Rates are in the unit of the first file. There must be at least one curve, and one row.
Plot check_plot(std::span<const JudgedCurve> curves);

}  // namespace twrench::plot
