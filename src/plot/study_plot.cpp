#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "base/time_unit.h"
#include "plot/gnuplot.h"
#include "plot/plots.h"
#include "scene/phrase.h"

namespace twrench::plot {
namespace {

using scene::Language;
using scene::Phrase;

constexpr Phrase error_at{"error of X at {}", "feil i X ved {}"};
constexpr Phrase relative_drift{"energy drift (relative)", "energidrift (relativ)"};

constexpr std::array<int, 13> symbols{6, 4, 8, 10, 12, 2, 1, 7, 5, 9, 11, 13, 3};

bool has_ladder(const study::MethodStudy& m) { return m.method->order > 0 && !m.runs.empty(); }

const study::StudyRun& middle(const study::MethodStudy& m) { return m.runs[m.runs.size() / 2]; }

/// The data blocks $run0, ... of step, early error, milliseconds, error and energy drift, and
/// $drift0, ... of t in that unit and energy drift. Omits values that have no logarithm.
std::string data(const study::Study& study, const TimeUnit& unit) {
  std::string text;
  const auto out = std::back_inserter(text);
  for (std::size_t i = 0; i < study.methods.size(); ++i) {
    const study::MethodStudy& m = study.methods[i];
    fmt::format_to(out, "$run{} << END\n", i);
    for (const study::StudyRun& run : m.runs) {
      if (!run.failure.empty() || !(run.error > 0.0)) continue;
      fmt::format_to(out, "{:.6g} {:.6g} {:.6g} {:.6g} {:.6g}\n", run.step, run.early_error,
                     1e3 * run.cpu_seconds, run.error, run.energy_drift);
    }
    fmt::format_to(out, "END\n$drift{} << END\n", i);
    const std::vector<double>& drift = middle(m).drift_in_time;
    for (std::size_t k = 0; k < drift.size(); ++k) {
      if (!(drift[k] > 0.0)) continue;
      const double t = (static_cast<double>(k) + 0.5) * study.duration / unit.length;
      fmt::format_to(out, "{:.6g} {:.6g}\n", t / static_cast<double>(drift.size()), drift[k]);
    }
    text += "END\n";
  }
  return text;
}

/// The style of method `i`: colour and symbol.
std::string style(std::size_t i, bool points) {
  const std::string line = fmt::format("lw 1.5 lc rgb '{}'", palette[i % palette.size()]);
  if (!points) return "with lines " + line;
  return fmt::format("with linespoints {} pt {} ps 0.8", line, symbols[i % symbols.size()]);
}

/// `behind` is plotted first.
std::string run_curves(const study::Study& study, std::string_view block, std::string_view columns,
                       bool points, std::string_view behind = {}) {
  std::string text = fmt::format("plot {}", behind);
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

constexpr double lowest_error = 1e-15, highest_error = 10;

/// The geometry of the diagram of errors against step sizes, used to find free places for labels.
class OrderDiagram {
 public:
  OrderDiagram(const study::Study& study, double width, double height)
      : width_(width), height_(height) {
    for (const study::MethodStudy& m : study.methods) {
      if (!has_ladder(m)) continue;
      for (const study::StudyRun& run : m.runs) {
        finest_ = std::min(finest_, run.step);
        coarsest_ = std::max(coarsest_, run.step);
      }
    }
    for (const study::MethodStudy& m : study.methods) {
      if (has_ladder(m)) add_curve(m.runs);
    }
    for (const int order : orders)
      add_line(pixel(finest_, reference(finest_, order)),
               pixel(coarsest_, reference(coarsest_, order)));
  }

  /// Reference slopes of orders 1, 2 and 4: broad faint lines behind the curves, each with a label
  /// beside it at the place with the most room.
  std::string slopes() {
    std::string text = fmt::format("set xrange [{:.6g}:{:.6g}]\n", low(), high());
    for (const int order : orders) {
      const Eigen::Vector2d place = label_place(order);
      taken_.push_back(place);
      text += fmt::format(
          "set arrow from {0:.6g}, {1:.6g} to {2:.6g}, {3} nohead back lw 5 lc rgb '#e4e4e4'\n"
          "set label 'h{4}' at {5:.6g}, {6:.6g} center front textcolor rgb '#707070'\n",
          finest_, reference(finest_, order), coarsest_, converging,
          order == 1 ? "" : fmt::format("^{}", order), step(place.x()), error(place.y()));
    }
    return text;
  }

 private:
  static constexpr std::array orders{1, 2, 4};
  static constexpr double converging = 3;  // error at the coarsest step of all reference lines

  double low() const { return finest_ / 1.4; }
  double high() const { return coarsest_ * 1.4; }
  double reference(double step, int order) const {
    return converging * std::pow(step / coarsest_, order);
  }
  Eigen::Vector2d pixel(double step, double error) const {
    return {width_ * std::log(step / low()) / std::log(high() / low()),
            height_ * std::log(error / lowest_error) / std::log(highest_error / lowest_error)};
  }
  double step(double x) const { return low() * std::pow(high() / low(), x / width_); }
  double error(double y) const {
    return lowest_error * std::pow(highest_error / lowest_error, y / height_);
  }

  void add_line(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
    constexpr int pieces = 40;
    for (int i = 0; i <= pieces; ++i) taken_.emplace_back(from + (to - from) * i / pieces);
  }
  void add_curve(const std::vector<study::StudyRun>& runs) {
    std::optional<Eigen::Vector2d> last;
    for (const study::StudyRun& run : runs) {
      if (!run.failure.empty() || !(run.early_error > 0.0)) continue;
      const Eigen::Vector2d here = pixel(run.step, run.early_error);
      add_line(last.value_or(here), here);
      last = here;
    }
  }

  double room(const Eigen::Vector2d& place) const {
    double room = std::min({place.x(), width_ - place.x(), place.y(), height_ - place.y()});
    for (const Eigen::Vector2d& other : taken_) room = std::min(room, (other - place).norm());
    return room;
  }
  Eigen::Vector2d label_place(int order) const {
    constexpr double beside = 14;  // pixels
    const Eigen::Vector2d from = pixel(finest_, reference(finest_, order));
    const Eigen::Vector2d way = pixel(coarsest_, converging) - from;
    const Eigen::Vector2d across = Eigen::Vector2d(-way.y(), way.x()).normalized();
    Eigen::Vector2d best = from;
    double most = -1;
    for (double along = 0; along < 0.9; along += 0.01) {
      for (const double side : {beside, -beside}) {
        const Eigen::Vector2d place = from + along * way + side * across;
        // The line itself is `beside` pixels away, so more room than that is no better.
        if (const double here = std::min(room(place), beside - 1); here > most) {
          best = place;
          most = here;
        }
      }
    }
    return best;
  }

  double width_, height_;  ///< In pixels.
  double finest_ = 1e300, coarsest_ = 0;
  std::vector<Eigen::Vector2d> taken_;
};

/// The title of the drift diagram: the methods' step sizes and tolerances.
std::string drift_title(const study::Study& study, Language language) {
  std::string step, tolerance;
  for (const study::MethodStudy& m : study.methods) {
    if (!has_ladder(m)) continue;
    const study::StudyRun& run = middle(m);
    if (run.tolerance) {
      tolerance = Phrase("tolerance {:.3g}", "toleranse {:.3g}").in(language, *run.tolerance);
    } else {
      step = Phrase("step {:.4g} s", "steg {:.4g} s").in(language, run.step);
    }
  }
  return Phrase("Energy: ", "Energi: ").in(language) + step +
         (step.empty() || tolerance.empty() ? "" : ", ") + tolerance;
}

std::string brief_time(double t) {
  const TimeUnit unit = time_unit(t);
  return fmt::format("{:.4g} {}", t / unit.length, unit.symbol);
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

/// The range of a member of all runs, times a factor.
std::string run_range(const study::Study& study, double study::StudyRun::*member, double factor) {
  std::vector<double> values;
  for (const study::MethodStudy& m : study.methods) {
    if (!has_ladder(m)) continue;
    for (const study::StudyRun& run : m.runs) values.push_back(factor * run.*member);
  }
  return decades(values);
}

std::string order_panel(const study::Study& study, const PanelGrid& grid, Language language) {
  return fmt::format("set format '10^{{%T}}'\nset logscale xy\nset yrange [{}:{}]\n", lowest_error,
                     highest_error) +
         OrderDiagram(study, grid.panel_width(), grid.panel_height()).slopes() +
         fmt::format("set title '{}'\nset xlabel '{}'\nset ylabel '{}' offset 1.5, 0\n",
                     Phrase("Order", "Orden").in(language),
                     Phrase("step h (s)", "steg h (s)").in(language),
                     error_at.in(language, brief_time(study.early))) +
         run_curves(study, "run", "1:2", true) + "unset arrow\nunset label\n";
}

std::string work_panel(const study::Study& study, Language language) {
  return fmt::format(
             "set xrange {}\nset title '{}'\nset xlabel '{}'\nset ylabel '{}' offset 1.5, 0\n",
             run_range(study, &study::StudyRun::cpu_seconds, 1e3),
             Phrase("Work and precision", "Arbeid og nøyaktighet").in(language),
             Phrase("CPU time (ms)", "prosessortid (ms)").in(language),
             error_at.in(language, brief_time(study.duration))) +
         run_curves(study, "run", "3:4", true);
}

/// The broad line shows where the error and the drift are equal.
std::string energy_panel(const study::Study& study, Language language) {
  return fmt::format("set xrange {}\nset title '{}'\nset xlabel '{}'\n",
                     run_range(study, &study::StudyRun::energy_drift, 1),
                     Phrase("Error against energy", "Feil mot energi").in(language),
                     relative_drift.in(language)) +
         run_curves(study, "run", "5:4", true, "x with lines lw 5 lc rgb '#e4e4e4' notitle, ");
}

std::string drift_panel(const study::Study& study, const TimeUnit& unit, Language language) {
  return fmt::format(
             "unset logscale x\nset format x '%g'\nset yrange {}\nset xrange [0:{:.7g}]\n"
             "set title {}\nset xlabel '{}'\nset ylabel '{}' offset 1.5, 0\n",
             drift_range(study), study.duration / unit.length,
             gnuplot_string(drift_title(study, language)), time_label(unit, language),
             relative_drift.in(language)) +
         run_curves(study, "drift", "1:2", false);
}

}  // namespace

Plot study_plot(const study::Study& study, Language language) {
  const TimeUnit unit = time_unit(study.duration);
  Plot plot{900, 960, data(study, unit)};
  const PanelGrid grid{plot.width, plot.height, 2, 2, 80, 18, 158, 36, 88, 106};
  plot.script.append(diagram_style)
      .append("set multiplot\n" + grid.place(0, 0) + order_panel(study, grid, language))
      .append(grid.place(0, 1) + work_panel(study, language))
      .append(grid.place(1, 0) + energy_panel(study, language))
      .append(grid.place(1, 1) + drift_panel(study, unit, language))
      .append(key_plot(key_entries(study), 4, 50.0 / plot.height) + "unset multiplot\n");
  return plot;
}

}  // namespace twrench::plot
