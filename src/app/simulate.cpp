#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/arguments.h"
#include "app/commands.h"
#include "app/output.h"
#include "app/scene_options.h"
#include "motion/diagnostics.h"
#include "motion/trajectory.h"

namespace twrench {
namespace {

struct Options {
  explicit Options(CLI::App& command) : scene(command) { scene.add_motion_options(); }

  SceneOptions scene;
  std::string times;
  std::string format = "csv";
  std::string output = "-";
};

/// Every 1/fps from 0 to the duration, both ends included.
std::vector<double> regular_times(const Scene& scene) {
  const double samples = std::floor(scene.motion.duration * scene.film.fps);
  if (samples > limits::most_frames) {
    throw UsageError("simulate",
                     fmt::format("there would be {} samples, but at most {} are allowed", samples,
                                 limits::most_frames),
                     "give a shorter --duration, a lower --fps, or --times");
  }
  std::vector<double> times;
  for (int i = 0; i <= static_cast<int>(samples); ++i) times.push_back(i / scene.film.fps);
  if (times.back() < scene.motion.duration) times.push_back(scene.motion.duration);
  return times;
}

std::vector<double> sample_times(const Options& options, const Scene& scene) {
  if (options.times.empty()) return regular_times(scene);
  std::vector<double> times = parse_numbers(options.times, "--times");
  for (const double t : times) limits::check({-1e9, 1e9}, "--times", t);
  return times;
}

std::string csv(const std::vector<Sample>& samples, const FreeBody& body, double start) {
  std::string text =
      "t,x11,x12,x13,x21,x22,x23,x31,x32,x33,wx,wy,wz,"
      "energy,energy_drift,orthogonality_error,momentum_error\n";
  const auto out = std::back_inserter(text);
  for (const Sample& s : samples) {
    const Diagnostics d = diagnose(body, start, s);
    fmt::format_to(out, "{:.17g}", s.t);
    for (int i = 0; i < 9; ++i) fmt::format_to(out, ",{:.17g}", s.X(i / 3, i % 3));
    for (const double w : s.omega) fmt::format_to(out, ",{:.17g}", w);
    fmt::format_to(out, ",{:.17g},{:.17g},{:.17g},{:.17g}\n", d.energy, d.energy_drift,
                   d.orthogonality_error, d.momentum_error);
  }
  return text;
}

std::string json(const Scene& scene, const std::vector<Sample>& samples, const FreeBody& body,
                 double start) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const Sample& s : samples) {
    const Diagnostics d = diagnose(body, start, s);
    std::vector<double> X;
    for (int i = 0; i < 9; ++i) X.push_back(s.X(i / 3, i % 3));
    rows.push_back({{"t", s.t},
                    {"X", X},
                    {"omega", std::vector<double>(s.omega.begin(), s.omega.end())},
                    {"energy", d.energy},
                    {"energy_drift", d.energy_drift},
                    {"orthogonality_error", d.orthogonality_error},
                    {"momentum_error", d.momentum_error}});
  }
  const nlohmann::ordered_json document{
      {"scene", scene.name}, {"method", scene.motion.method}, {"samples", rows}};
  return document.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

void simulate(const Options& options) {
  options.scene.require_not_input(options.output);
  const Scene scene = options.scene.scene();
  const FreeBody body = free_body(mass_properties(scene.body).inertia, scene.motion.omega);
  const std::vector<double> times = sample_times(options, scene);
  const auto samples =
      trajectory(body, find_method(scene.motion.method), scene.motion.control, times).samples;
  const double start = energy(body.inertia, scene.motion.omega);
  write_output(options.output, options.format == "csv" ? csv(samples, body, start)
                                                       : json(scene, samples, body, start));
}

}  // namespace

void add_simulate(CLI::App& app) {
  CLI::App* command = app.add_subcommand("simulate", "The trajectory as CSV or JSON");
  command->footer(std::string(about_defaults) +
                  "Example: twrench simulate stable-y --method rk4 --times 1,10,100");
  const auto options = std::make_shared<Options>(*command);
  command->add_option("--times", options->times, "sample at exactly these times, s")
      ->type_name("T1,T2,...");
  command->add_option("--format", options->format, "csv or json")
      ->check(one_of("--format", {"csv", "json"}))
      ->type_name("FORMAT")
      ->capture_default_str();
  command->add_option("-o,--output", options->output, "file, or - for standard output")
      ->capture_default_str();
  command->callback([options] { simulate(*options); });
}

}  // namespace twrench
