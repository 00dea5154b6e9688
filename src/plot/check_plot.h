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

/// Returns the errors of rates and of attitudes against time on a logarithmic scale, with a panel
/// for each kind that is present. A dashed line shows the resolution limit of the digits. Rates are
/// in the unit of the first file. There must be at least one curve, and one row.
Plot check_plot(std::span<const JudgedCurve> curves);

}  // namespace twrench::plot
