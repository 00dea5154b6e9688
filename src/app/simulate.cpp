#include <fmt/format.h>
#include <twrench/base/error.h>
#include <twrench/motion/diagnostics.h>
#include <twrench/motion/trajectory.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/arguments.h"
#include "app/commands.h"
#include "app/output.h"
#include "app/scene_options.h"
#include "scene/limits.h"

namespace twrench::app {
namespace {

struct SimulateOptions {
  explicit SimulateOptions(CLI::App& command) : scene(command) { scene.add_motion_options(); }

  SceneOptions scene;
  std::string times;
  std::string format = "csv";
  std::string output = "-";
};

/// Every 1/fps from 0 to the duration, both ends included.
class RegularTimes {
 public:
  explicit RegularTimes(const scene::Scene& scene)
      : duration_(scene.motion.duration), fps_(scene.film.fps) {
    const double whole = std::floor(duration_ * fps_);
    if (whole > scene::limits::max_frames) {
      throw InvalidArgument("simulate",
                            fmt::format("there would be {} samples, but at most {} are allowed",
                                        whole, scene::limits::max_frames),
                            "use a shorter --duration, a lower --fps, or --times");
    }
    regular_ = static_cast<std::size_t>(whole) + 1;
  }

  std::size_t size() const { return regular_ + (last_regular() < duration_ ? 1 : 0); }
  double operator()(std::size_t i) const {
    return i < regular_ ? static_cast<double>(i) / fps_ : duration_;
  }

 private:
  double last_regular() const { return static_cast<double>(regular_ - 1) / fps_; }

  double duration_, fps_;
  std::size_t regular_;
};

std::vector<double> times_asked_for(const SimulateOptions& options) {
  std::vector<double> times = parse_numbers(options.times, "--times");
  for (const double t : times) scene::limits::check({-1e9, 1e9}, "--times", t);
  return times;
}

/// The text before, between and after the samples, and that of a sample.
struct Format {
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

Format csv() {
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

Format json(const scene::Scene& scene) {
  const nlohmann::ordered_json document{{"scene", scene.name},
                                        {"method", scene.motion.method},
                                        {"samples", nlohmann::ordered_json::array()}};
  const std::string text =
      document.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  const std::size_t samples = text.rfind(']');
  return {text.substr(0, samples) + "\n  ", ",\n  ", "\n " + text.substr(samples) + "\n", json_row};
}

void simulate(const SimulateOptions& options) {
  options.scene.require_not_input(options.output);
  const scene::Scene scene = options.scene.scene();
  const motion::Method& method = motion::find_method(scene.motion.method);
  const motion::FreeBody body(scene::mass_properties(scene.body).inertia, scene.motion.omega);
  const double start = motion::energy(body.inertia(), scene.motion.omega);
  const Format format = options.format == "csv" ? csv() : json(scene);
  Output output(options.output);
  output.write(format.before);
  bool first = true;
  const auto write = [&](const motion::Sample& sample) {
    if (!first) output.write(format.between);
    first = false;
    output.write(format.row(sample, motion::diagnose(body, start, sample)));
  };
  if (options.times.empty()) {
    const RegularTimes times(scene);
    motion::visit_samples(body, method, scene.motion.control, times.size(), times, write);
  } else {
    const std::vector<double> times = times_asked_for(options);
    std::ranges::for_each(motion::integrate(body, method, scene.motion.control, times).samples,
                          write);
  }
  output.write(format.after);
  output.finish();
}

}  // namespace

void add_simulate(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("simulate", "Compute the trajectory and write it as CSV or JSON");
  command->footer(std::string(about_defaults) +
                  "Example: twrench simulate stable-y --method rk4 --times 1,10,100");
  const auto options = std::make_shared<SimulateOptions>(*command);
  command->add_option("--times", options->times, "sample at exactly these times, s")
      ->type_name("T1,T2,...")
      ->default_str("every 1/fps");
  command->add_option("--format", options->format, "output format: csv or json")
      ->check(one_of("--format", {"csv", "json"}))
      ->type_name("FORMAT")
      ->capture_default_str();
  command->add_option("-o,--output", options->output, "output file, or - for standard output")
      ->type_name("FILE")
      ->capture_default_str();
  command->callback([options] { simulate(*options); });
}

}  // namespace twrench::app
