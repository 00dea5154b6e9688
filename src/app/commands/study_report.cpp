#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <numbers>

#include "app/commands/commands.h"

namespace twrench::app {
namespace {

using Json = nlohmann::ordered_json;

/// Formats a number for a table.
std::string brief(double value) {
  return std::isfinite(value) ? fmt::format("{:.2e}", value) : "-";
}

std::string brief(const std::optional<double>& value) {
  return value ? fmt::format("{:.4g}", *value) : "-";
}

/// Avoids a minus sign before 0.00.
std::string hundredths(double value) {
  return fmt::format("{:.2f}", std::round(100.0 * value) / 100.0 + 0.0);
}

std::string reference_text(const study::Study& study) {
  if (study.reference->exact()) return "the exact solution";
  return fmt::format("{} at tolerance {}, because the motion has no closed form",
                     study.reference->name, motion::min_tolerance);
}

std::string flips_heading(const study::Study& study) {
  if (study.loses_energy) {
    return "Flips: not counted, because they cease as the body loses energy.\n";
  }
  if (!study.reference->exact()) {
    return fmt::format("Flips (sign changes of omega along the intermediate axis) of {}: {}.\n",
                       study.reference->name, study.flip_times.size());
  }
  if (!study.flips) return "Flips: none; omega is constant, or there is no intermediate axis.\n";
  const motion::ExactMotion::Flips& flips = *study.flips;
  if (!std::isfinite(flips.interval)) {
    return "Flips: at most one; on the separatrix the rotation settles on the intermediate axis.\n";
  }
  return fmt::format(
      "Flips (sign changes of omega along the intermediate axis): {} predicted, every {:.12f} s\n"
      "= 2K/|lambda| (asymptotically ln(16/mc)/|lambda| = {:.12f} s). Swing of the axis: {:.1f} "
      "degrees.\n",
      study.flip_times.size(), flips.interval, flips.asymptotic_interval,
      flips.swing * 180 / std::numbers::pi);
}

std::string run_line(const study::Study& study, const study::StudyRun& run, bool has_step) {
  const std::string step = has_step ? fmt::format("{:.6g}", run.step) : "-";
  const std::string start = fmt::format("{:>12}{:>10}", step, brief(run.tolerance));
  if (!run.failure.empty()) return fmt::format("{}  {}\n", start, run.failure);
  return fmt::format("{}{:>12}{:>12}{:>10}{:>10}{:>10}{:>9}{:>12}{:>12}{:>10.3f}\n", start,
                     brief(run.early_error), brief(run.error), brief(run.energy_drift),
                     brief(run.orthogonality_error), brief(run.momentum_error),
                     fmt::format("{}/{}", run.flips.size(), study.flip_times.size()),
                     brief(run.flip_error), run.evaluations, 1e3 * run.cpu_seconds);
}

std::string runs_text(const study::Study& study) {
  std::string text = fmt::format(
      "{:>12}{:>10}{:>12}{:>12}{:>10}{:>10}{:>10}{:>9}{:>12}{:>12}{:>10}\n", "step, s", "tolerance",
      fmt::format("X at {:.4g} s", study.early), fmt::format("X at {:.4g} s", study.duration),
      "energy", "X^T X-Id", "momentum", "flips", "flip err, s", "evaluations", "CPU, ms");
  for (const study::MethodStudy& m : study.methods) {
    const std::string order =
        m.order ? fmt::format("observed order {:.2f}", *m.order) : "no observed order";
    text += m.method->exact() ? "exact: the reference for the other methods\n"
                              : fmt::format("{}: {}\n", m.method->name, order);
    for (const study::StudyRun& run : m.runs) text += run_line(study, run, !m.method->exact());
  }
  return text;
}

std::string estimates_text(const study::Study& study) {
  std::string text;
  for (const study::MethodStudy& m : study.methods) {
    if (!m.method->adaptive()) continue;
    text += fmt::format("{}: true/E scales as step^{}\n", m.method->name,
                        m.estimate_exponent ? hundredths(*m.estimate_exponent) : "?");
    for (const study::StudyRun& run : m.runs) {
      if (!run.estimate) continue;
      text += fmt::format("{:>12.6g}{:>10}{:>16}{:>17}{:>24}\n", run.step, brief(run.tolerance),
                          brief(run.estimate->median_ratio), brief(run.estimate->largest_ratio),
                          brief(run.estimate->largest_error / *run.tolerance));
    }
  }
  if (text.empty()) return text;
  return "\nError estimate E of each accepted step, compared with its true local error\n" +
         fmt::format("{:>12}{:>10}{:>16}{:>17}{:>24}\n", "mean step, s", "tolerance",
                     "true/E, median", "true/E, largest", "true/tolerance, largest") +
         text;
}

/// The first values of a row, as many as fit on a line.
std::string flip_row(const std::string& name, const std::string& step,
                     const std::vector<double>& values) {
  constexpr std::size_t most = 6;
  std::string line = fmt::format("{:<19}{:>10}", name, step);
  for (std::size_t i = 0; i < std::min(values.size(), most); ++i) {
    line += fmt::format("{:>15.9f}", values[i]);
  }
  return line + (values.size() > most ? " ...\n" : "\n");
}

std::vector<double> intervals(const std::vector<double>& times) {
  std::vector<double> between(times.size());
  std::adjacent_difference(times.begin(), times.end(), between.begin());
  if (!between.empty()) between.erase(between.begin());
  return between;
}

/// For each method, the flips of its finest run that did not fail.
std::string flips_text(const study::Study& study) {
  if (study.flip_times.empty()) return {};
  std::string at = "\nFlip times in s, each method at its finest step\n" +
                   flip_row("predicted", "", study.flip_times);
  std::string between =
      "\nTime between flips in s\n" + flip_row("predicted", "", intervals(study.flip_times));
  for (const study::MethodStudy& m : study.methods) {
    const study::StudyRun* finest = nullptr;
    for (const study::StudyRun& run : m.runs) {
      if (run.failure.empty() && (finest == nullptr || run.step < finest->step)) finest = &run;
    }
    if (finest == nullptr) continue;
    const std::string name(m.method->name), step = fmt::format("{:.4g}", finest->step);
    at += flip_row(name, step, finest->flips);
    between += flip_row(name, step, intervals(finest->flips));
  }
  return study.flip_times.size() > 1 ? at + between : at;
}

Json estimate_json(const study::StudyRun& run) {
  if (!run.estimate) return nullptr;
  return {{"median_ratio", run.estimate->median_ratio},
          {"largest_ratio", run.estimate->largest_ratio},
          {"largest_true_error", run.estimate->largest_error}};
}

Json or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json run_json(const study::StudyRun& run) {
  if (!run.failure.empty()) {
    return {{"step", run.step}, {"tolerance", or_null(run.tolerance)}, {"failure", run.failure}};
  }
  return {{"step", run.step},
          {"tolerance", or_null(run.tolerance)},
          {"early_error", run.early_error},
          {"error", run.error},
          {"energy_drift", run.energy_drift},
          {"orthogonality_error", run.orthogonality_error},
          {"momentum_error", run.momentum_error},
          {"flips", run.flips},
          {"flip_error", run.flip_error},
          {"steps", run.steps},
          {"evaluations", run.evaluations},
          {"cpu_seconds", run.cpu_seconds},
          {"estimate", estimate_json(run)}};
}

Json flips_json(const study::Study& study) {
  if (!study.flips) return nullptr;
  return {{"interval", study.flips->interval},
          {"asymptotic_interval", study.flips->asymptotic_interval},
          {"swing", study.flips->swing},
          {"times", study.flip_times}};
}

}  // namespace

std::string study_text(const study::Study& study, const std::string& scene) {
  return fmt::format("{}: {} s of motion, methods compared with {}\n\n{}\n{}{}{}", scene,
                     study.duration, reference_text(study), flips_heading(study), runs_text(study),
                     estimates_text(study), flips_text(study));
}

std::string study_csv(const study::Study& study) {
  std::string text =
      "method,order_seen,step,tolerance,early_error,error,energy_drift,orthogonality_error,"
      "momentum_error,"
      "flips_predicted,flips_observed,flip_error,steps,evaluations,cpu_seconds,"
      "estimate_median_ratio,estimate_largest_ratio,estimate_largest_true_error,failure\n";
  const auto number = [](double value) {
    return std::isfinite(value) ? fmt::format("{}", value) : std::string();
  };
  const auto maybe = [&](const std::optional<double>& value) {
    return value ? number(*value) : std::string();
  };
  for (const study::MethodStudy& m : study.methods) {
    for (const study::StudyRun& r : m.runs) {
      text += fmt::format("{},{},{},{}", m.method->name, maybe(m.order), number(r.step),
                          maybe(r.tolerance));
      if (!r.failure.empty()) {
        text += fmt::format(",,,,,,,,,,,,,,,\"{}\"\n", r.failure);
        continue;
      }
      text += fmt::format(",{},{},{},{},{},{},{},{},{},{},{}", number(r.early_error),
                          number(r.error), number(r.energy_drift), number(r.orthogonality_error),
                          number(r.momentum_error), study.flip_times.size(), r.flips.size(),
                          number(r.flip_error), r.steps, r.evaluations, number(r.cpu_seconds));
      const study::EstimateQuality none{std::nan(""), std::nan(""), std::nan("")};
      const study::EstimateQuality e = r.estimate.value_or(none);
      text += fmt::format(",{},{},{},\n", number(e.median_ratio), number(e.largest_ratio),
                          number(e.largest_error));
    }
  }
  return text;
}

std::string study_json(const study::Study& study, const std::string& scene) {
  Json all = Json::array();
  for (const study::MethodStudy& m : study.methods) {
    Json runs = Json::array();
    for (const study::StudyRun& run : m.runs) runs.push_back(run_json(run));
    all.push_back({{"method", m.method->name},
                   {"order", m.method->order.value_or(0)},
                   {"order_seen", or_null(m.order)},
                   {"estimate_exponent", or_null(m.estimate_exponent)},
                   {"runs", runs}});
  }
  const Json document{
      {"scene", scene},       {"reference", study.reference->name}, {"duration", study.duration},
      {"early", study.early}, {"flips", flips_json(study)},         {"methods", all}};
  return document.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace twrench::app
