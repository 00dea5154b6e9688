#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <vector>

#include "base/time_unit.h"
#include "plot/gnuplot.h"
#include "plot/plots.h"
#include "recording/conventions/units.h"

namespace twrench::plot {
namespace {

/// A panel of errors and their limits.
struct ErrorPanel {
  std::string title, unit, block;  ///< block: name of the data
  double factor;                   ///< from our unit to the panel's
  double check::Span::*error;
  double check::Span::*limit;
  std::vector<std::size_t> curves;  ///< the curves that have this error
};

std::vector<ErrorPanel> panels_of(std::span<const JudgedCurve> curves) {
  constexpr double per_radian = 180 / std::numbers::pi;
  const recording::RateUnitName& rates =
      recording::name_of(recording::rate_unit(curves.front().judgement->convention));
  std::vector<ErrorPanel> panels{{"Rates",
                                  rates.symbol,
                                  "rates",
                                  1 / rates.in_rad_s,
                                  &check::Span::rate_error,
                                  &check::Span::rate_limit,
                                  {}},
                                 {"Attitude",
                                  "deg",
                                  "attitude",
                                  per_radian,
                                  &check::Span::attitude_error,
                                  &check::Span::attitude_limit,
                                  {}}};
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (curves[i].judgement->has_rates) panels[0].curves.push_back(i);
    if (curves[i].judgement->has_attitude) panels[1].curves.push_back(i);
  }
  std::erase_if(panels, [](const ErrorPanel& panel) { return panel.curves.empty(); });
  return panels;
}

/// Writes the time in that unit, the error and the limit. An error of zero has no logarithm and
/// leaves a gap.
std::string data(const ErrorPanel& panel, std::span<const JudgedCurve> curves,
                 const TimeUnit& unit) {
  std::string text;
  const auto out = std::back_inserter(text);
  for (const std::size_t i : panel.curves) {
    fmt::format_to(out, "${}{} << END\n", panel.block, i);
    const check::Judgement& judgement = *curves[i].judgement;
    for (const check::Span& span : judgement.course) {
      const double t = check::clock_time(judgement, span.last.t);
      const double error = panel.factor * span.*panel.error;
      fmt::format_to(out, "{:.15g} {} {:.6g}\n", t / unit.length,
                     error > 0 ? fmt::format("{:.6g}", error) : "NaN",
                     panel.factor * span.*panel.limit);
    }
    text += "END\n";
  }
  return text;
}

std::string curve_color(std::size_t i) { return std::string(palette[i % palette.size()]); }

std::string line_style(std::size_t i) { return fmt::format("lw 1.5 lc rgb '{}'", curve_color(i)); }

/// The style of a curve's limit: in the curve's colour, or in gray if there is only one curve.
std::string limit_style(std::size_t i, std::size_t curves) {
  return fmt::format("dt (6,4) lw 1.2 lc rgb '{}'", curves == 1 ? "#606060" : curve_color(i));
}

/// The decades that contain all errors and limits.
std::string range(const ErrorPanel& panel, std::span<const JudgedCurve> curves) {
  double low = INFINITY, high = 0;
  for (const std::size_t i : panel.curves) {
    for (const check::Span& span : curves[i].judgement->course) {
      for (const double value : {span.*panel.error, span.*panel.limit}) {
        if (!(value > 0 && std::isfinite(value))) continue;
        low = std::min(low, panel.factor * value);
        high = std::max(high, panel.factor * value);
      }
    }
  }
  if (!(high > 0)) return "[1e-16:1]";
  return fmt::format("[1e{}:1e{}]", std::floor(std::log10(low)), std::floor(std::log10(high)) + 1);
}

/// The range of time that the curves cover in s.
struct Times {
  double from = INFINITY, to = -INFINITY;
};

Times times_of(std::span<const JudgedCurve> curves) {
  auto [from, to] = Times{};
  for (const JudgedCurve& curve : curves) {
    from = std::min(from, curve.judgement->first_time);
    to = std::max(to, check::clock_time(*curve.judgement, curve.judgement->duration));
  }
  return {from, to};
}

std::string range(const Times& times, const TimeUnit& unit) {
  if (!(times.from < times.to)) return "[*:*]";
  return fmt::format("[{:.15g}:{:.15g}]", times.from / unit.length, times.to / unit.length);
}

std::string draw(const ErrorPanel& panel, std::span<const JudgedCurve> curves) {
  std::string text = "plot ";
  for (const std::size_t i : panel.curves) {
    text += fmt::format(
        "${0}{1} using 1:3 with lines {2} notitle, ${0}{1} using 1:2 with lines {3} notitle, ",
        panel.block, i, limit_style(i, curves.size()), line_style(i));
  }
  return text + "NaN notitle\n";
}

std::string key(std::span<const JudgedCurve> curves) {
  std::string text;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    text += fmt::format(", keyentry with lines {} title {} noenhanced", line_style(i),
                        gnuplot_string(curves[i].title));
  }
  return text + fmt::format(", keyentry with lines {} title 'resolution limit of the digits'",
                            limit_style(0, 1));
}

}  // namespace

Plot check_plot(std::span<const JudgedCurve> curves) {
  const std::vector<ErrorPanel> panels = panels_of(curves);
  const int columns = static_cast<int>(panels.size());
  const int key_rows = (static_cast<int>(curves.size()) + 2) / 2;
  const int below = 70 + 24 * key_rows;
  Plot plot{columns == 1 ? 760 : 1280, 460 + below, {}};
  const PanelGrid grid{plot.width, plot.height, 1, columns, 86, 22, below, 42, 100, 0};
  const Times times = times_of(curves);
  const TimeUnit unit = times.from < times.to ? time_unit(times.to - times.from) : time_unit(1);
  for (const ErrorPanel& panel : panels) plot.script += data(panel, curves, unit);
  plot.script.append(diagram_style).append("set multiplot\n");
  for (int column = 0; column < columns; ++column) {
    const ErrorPanel& panel = panels[static_cast<std::size_t>(column)];
    plot.script.append(grid.place(0, column))
        .append(fmt::format("set logscale y\nset format y '10^{{%T}}'\nset xlabel 't ({})'\n",
                            unit.name))
        .append(fmt::format("set xrange {}\nset yrange {}\nset title '{}'\n", range(times, unit),
                            range(panel, curves), panel.title))
        .append(fmt::format("set ylabel 'error ({})' offset 0.6, 0\n", panel.unit))
        .append(draw(panel, curves));
  }
  plot.script += key_plot(key(curves), 2, 14.0 / plot.height + 12.0 * key_rows / plot.height) +
                 "unset multiplot\n";
  return plot;
}

}  // namespace twrench::plot
