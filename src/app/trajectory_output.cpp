#include "app/trajectory_output.h"

#include <fmt/format.h>
#include <twrench/base/error.h>
#include <twrench/motion/diagnostics.h>
#include <twrench/motion/trajectory.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>

#include "scene/limits.h"

namespace twrench::app {
namespace {

/// The text before, between and after the samples, and that of a sample.
struct TextFormat {
  std::string before, between, after;
  std::function<std::string(const motion::Sample&, const motion::Diagnostics&)> row;
};

std::string csv_row(const motion::Sample& s, const motion::Diagnostics& d) {
  std::string text = fmt::format("{:.17g}", s.t);
  const auto out = std::back_inserter(text);
  for (int i = 0; i < 9; ++i) fmt::format_to(out, ",{:.17g}", s.X(i / 3, i % 3));
  for (const double w : s.omega) fmt::format_to(out, ",{:.17g}", w);
  fmt::format_to(out, ",{:.17g},{:.17g},{:.17g},{:.17g}\n", d.energy, d.energy_drift,
                 d.orthogonality_error, d.momentum_error);
  return text;
}

TextFormat csv_format() {
  return {
      "t,x11,x12,x13,x21,x22,x23,x31,x32,x33,wx,wy,wz,"
      "energy,energy_drift,orthogonality_error,momentum_error\n",
      "", "", csv_row};
}

/// Indented to its depth in the document.
std::string json_row(const motion::Sample& s, const motion::Diagnostics& d) {
  const auto X = s.X.reshaped<Eigen::RowMajor>();
  const nlohmann::ordered_json row{{"t", s.t},
                                   {"X", std::vector<double>(X.begin(), X.end())},
                                   {"omega", std::vector<double>(s.omega.begin(), s.omega.end())},
                                   {"energy", d.energy},
                                   {"energy_drift", d.energy_drift},
                                   {"orthogonality_error", d.orthogonality_error},
                                   {"momentum_error", d.momentum_error}};
  std::string text;
  for (const char c : row.dump(1)) {
    text += c;
    if (c == '\n') text += "  ";
  }
  return text;
}

TextFormat json_format(const scene::Scene& scene) {
  const nlohmann::ordered_json document{{"scene", scene.name},
                                        {"method", scene.motion.method},
                                        {"samples", nlohmann::ordered_json::array()}};
  const std::string text =
      document.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  const std::size_t samples = text.rfind(']');
  return {text.substr(0, samples) + "\n  ", ",\n  ", "\n " + text.substr(samples) + "\n", json_row};
}

}  // namespace

RegularTimes::RegularTimes(const scene::Scene& scene)
    : duration_(scene.motion.duration), fps_(scene.film.fps) {
  const double whole = std::floor(duration_ * fps_);
  if (whole > scene::limits::max_frames) {
    throw InvalidArgument("samples",
                          fmt::format("there would be {}, but at most {} are allowed", whole,
                                      scene::limits::max_frames),
                          "use a shorter --duration, or a lower --fps");
  }
  regular_ = static_cast<std::size_t>(whole) + 1;
}

void write_trajectory(Output& output, const scene::Scene& scene, const std::string& format,
                      const std::vector<double>& times) {
  const motion::Method& method = motion::find_method(scene.motion.method);
  const motion::FreeBody body(scene::mass_properties(scene.body).inertia, scene.motion.omega);
  const double start = motion::energy(body.inertia(), scene.motion.omega);
  const TextFormat text = format == "csv" ? csv_format() : json_format(scene);
  output.write(text.before);
  bool first = true;
  const auto write = [&](const motion::Sample& sample) {
    if (!first) output.write(text.between);
    first = false;
    output.write(text.row(sample, motion::diagnose(body, start, sample)));
  };
  if (times.empty()) {
    const RegularTimes regular(scene);
    motion::visit_samples(body, method, scene.motion.control, regular.size(), regular, write);
  } else {
    std::ranges::for_each(motion::integrate(body, method, scene.motion.control, times).samples,
                          write);
  }
  output.write(text.after);
}

}  // namespace twrench::app
