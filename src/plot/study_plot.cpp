#include "plot/study_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "plot/panels.h"

namespace twrench::plot {
namespace {

constexpr std::array<int, 13> symbols{6, 4, 8, 10, 12, 2, 1, 7, 5, 9, 11, 13, 3};

bool has_ladder(const study::MethodStudy& m) { return m.method->order > 0 && !m.runs.empty(); }

const study::StudyRun& middle(const study::MethodStudy& m) { return m.runs[m.runs.size() / 2]; }

/// The data blocks $run0, ... of step, early error and milliseconds, and $drift0, ... of t and
/// energy drift. Omits values that have no logarithm.
std::string data(const study::Study& study) {
  std::string text;
  const auto out = std::back_inserter(text);
  for (std::size_t i = 0; i < study.methods.size(); ++i) {
    const study::MethodStudy& m = study.methods[i];
    fmt::format_to(out, "$run{} << END\n", i);
    for (const study::StudyRun& run : m.runs) {
      if (!run.failure.empty() || !(run.error > 0.0)) continue;
      fmt::format_to(out, "{:.6g} {:.6g} {:.6g} {:.6g}\n", run.step, run.early_error,
                     1e3 * run.cpu_seconds, run.error);
    }
    fmt::format_to(out, "END\n$drift{} << END\n", i);
    const std::vector<double>& drift = middle(m).drift_in_time;
    for (std::size_t k = 0; k < drift.size(); ++k) {
      if (!(drift[k] > 0.0)) continue;
      const double t = (static_cast<double>(k) + 0.5) * study.duration;
      fmt::format_to(out, "{:.6g} {:.6g}\n", t / static_cast<double>(drift.size()), drift[k]);
    }
    text += "END\n";
  }
  return text;
}

/// The style of method `i`: colour, symbol and, after the colours repeat, dashes.
std::string style(std::size_t i, bool points) {
  const std::string line = fmt::format(
      "lw 1.5 dt {} lc rgb '{}'", i < palette.size() ? "1" : "(6,3)", palette[i % palette.size()]);
  if (!points) return "with lines " + line;
  return fmt::format("with linespoints {} pt {} ps 0.8", line, symbols[i % symbols.size()]);
}

std::string run_curves(const study::Study& study, std::string_view block, std::string_view columns,
                       bool points) {
  std::string text = "plot ";
  for (std::size_t i = 0; i < study.methods.size(); ++i) {
    if (!has_ladder(study.methods[i])) continue;
    text += fmt::format("${}{} using {} {} notitle, ", block, i, columns, style(i, points));
  }
  return text + "NaN notitle\n";
}

std::string key_entries(const study::Study& study) {
  std::string text;
  for (std::size_t i = 0; i < study.methods.size(); ++i) {
    if (!has_ladder(study.methods[i])) continue;
    text += fmt::format(", keyentry {} title '{}'", style(i, true), study.methods[i].method->name);
  }
  return text;
}

/// Reference slopes of orders 1, 2 and 4: broad faint labelled lines behind the curves.
std::string slopes(const study::Study& study) {
  constexpr double highest = 3.0;
  double finest = 1e300, coarsest = 0.0;
  for (const study::MethodStudy& m : study.methods) {
    if (!has_ladder(m)) continue;
    for (const study::StudyRun& run : m.runs) {
      finest = std::min(finest, run.step);
      coarsest = std::max(coarsest, run.step);
    }
  }
  std::string text = fmt::format("set xrange [{:.6g}:{:.6g}]\n", finest / 1.4, coarsest * 1.4);
  for (const int order : {1, 2, 4}) {
    const double height = highest * std::pow(finest / coarsest, order);
    text += fmt::format(
        "set arrow from {0:.6g}, {1:.6g} to {2:.6g}, {3} nohead back lw 5 lc rgb '#e4e4e4'\n"
        "set label 'h{4}' at {0:.6g}, {1:.6g} left offset 0.3, 0.8 front "
        "textcolor rgb '#707070'\n",
        finest, height, coarsest, highest, order == 1 ? "" : fmt::format("^{}", order));
  }
  return text;
}

/// The methods' step sizes and tolerances in the drift diagram.
std::string drift_title(const study::Study& study) {
  std::string step, tolerance;
  for (const study::MethodStudy& m : study.methods) {
    if (!has_ladder(m)) continue;
    const study::StudyRun& run = middle(m);
    if (run.tolerance) {
      tolerance = fmt::format("tolerance {:.3g}", *run.tolerance);
    } else {
      step = fmt::format("step {:.4g} s", run.step);
    }
  }
  return step + (step.empty() || tolerance.empty() ? "" : ", ") + tolerance;
}

/// The range of decades, in gnuplot's syntax, that contains the positive values.
std::string decades(const std::vector<double>& values) {
  double low = 1.0, high = 0.0;
  for (const double v : values) {
    if (!(v > 0.0 && std::isfinite(v))) continue;
    low = high > 0.0 ? std::min(low, v) : v;
    high = std::max(high, v);
  }
  if (!(high > 0.0)) return "[1e-16:1]";
  return fmt::format("[1e{}:1e{}]", std::floor(std::log10(low)),
                     std::floor(std::log10(high)) + 1.0);
}

std::string drift_range(const study::Study& study) {
  std::vector<double> drifts;
  for (const study::MethodStudy& m : study.methods) {
    if (!has_ladder(m)) continue;
    const std::vector<double>& drift = middle(m).drift_in_time;
    drifts.insert(drifts.end(), drift.begin(), drift.end());
  }
  return decades(drifts);
}

std::string time_range(const study::Study& study) {
  std::vector<double> times;
  for (const study::MethodStudy& m : study.methods) {
    if (!has_ladder(m)) continue;
    for (const study::StudyRun& run : m.runs) times.push_back(1e3 * run.cpu_seconds);
  }
  return decades(times);
}

}  // namespace

Plot study_plot(const study::Study& study) {
  Plot plot{1380, 600, data(study)};
  const PanelGrid grid{plot.width, plot.height, 1, 3, 78, 18, 146, 42, 84, 0};
  std::string& script = plot.script;
  script.append(diagram_style)
      .append("set multiplot\n" + grid.place(0, 0))
      .append(
          "set format '10^{%T}'\n"
          "set logscale xy\n"
          "set yrange [1e-15:10]\n"
          "set xlabel 'step h (s)'\n")
      .append(slopes(study))
      .append(fmt::format("set title 'Order'\n"
                          "set ylabel 'error of X at {:.4g} s' offset 1.5, 0\n",
                          study.early))
      .append(run_curves(study, "run", "1:2", true))
      .append("unset arrow\nunset label\nset xrange " + time_range(study) + "\n" + grid.place(0, 1))
      .append(fmt::format("set title 'Work and precision'\n"
                          "set xlabel 'CPU time (ms)'\n"
                          "set ylabel 'error of X at {:.4g} s'\n",
                          study.duration))
      .append(run_curves(study, "run", "3:4", true))
      .append(grid.place(0, 2))
      .append(fmt::format("unset logscale x\n"
                          "set format x '%g'\n"
                          "set yrange {}\n"
                          "set xrange [0:{:.7g}]\n"
                          "set title {}\n"
                          "set xlabel 't (s)'\n"
                          "set ylabel 'energy drift (relative)' offset 0.8, 0\n",
                          drift_range(study), study.duration,
                          gnuplot_string("Energy: " + drift_title(study))))
      .append(run_curves(study, "drift", "1:2", false))
      .append(key_plot(key_entries(study), 6, 42.0 / plot.height) + "unset multiplot\n");
  return plot;
}

}  // namespace twrench::plot
