// The functions that JavaScript calls (core.js). Arguments and results that are not single numbers
// are in a scratch area of doubles: a function reads its arguments from the beginning of this area
// and writes its results to the same place.

#include <fmt/format.h>
#include <twrench/base/error.h>
#include <twrench/body/mass_properties.h>
#include <twrench/motion/diagnostics.h>
#include <twrench/motion/exact.h>
#include <twrench/motion/method.h>
#include <twrench/motion/stability.h>
#include <twrench/motion/trajectory.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "body/dimensions.h"
#include "method_run.h"
#include "motion.h"
#include "motion/recorded_motion.h"
#include "scene/scene.h"
#include "scratch.h"

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using namespace twrench;
using page::matrix_at;
using page::Motion;
using page::numbers;
using page::Results;
using page::RowMajor;
using page::vector_at;

/// Replaces the times at the beginning of the area by the samples: all X, then all omega.
void write_samples(const std::vector<motion::Sample>& samples) {
  Results results(12 * samples.size());
  for (const motion::Sample& sample : samples) results << sample.X;
  for (const motion::Sample& sample : samples) results << sample.omega;
}

std::vector<double> times_at_beginning(std::size_t n) {
  return {numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(n)};
}

/// Reads parts, each as the index of its shape in shapes(), its dimensions in their order, density,
/// position and rotation.
std::vector<body::Part> parts_at_beginning(std::size_t count) {
  std::size_t next = 0;
  std::vector<body::Part> parts;
  for (std::size_t i = 0; i < count; ++i) {
    body::Shape shape = body::all_shapes().at(static_cast<std::size_t>(numbers.at(next++)));
    for (const body::Dimension& dimension : body::dimensions(shape)) {
      for (double& value : dimension.values) value = numbers.at(next++);
    }
    constexpr std::size_t rest = 1 + 3 + 9;
    if (next + rest > numbers.size()) throw InvalidArgument("parts", "lack numbers");
    parts.push_back({shape, numbers[next], vector_at(next + 1), matrix_at(next + 4)});
    next += rest;
  }
  return parts;
}

}  // namespace

extern "C" {

/// Makes room for `count` doubles, the first of which may already be set.
[[clang::export_name("scratch")]] double* scratch(std::size_t count) {
  if (numbers.size() < count) numbers.resize(count);
  return numbers.data();
}

/// All methods as JSON, in the terms of core.js.
[[clang::export_name("methods")]] const char* methods() {
  static std::string json;
  json = "[";
  for (const motion::Method& m : motion::methods()) {
    json += fmt::format(R"({}{{"name":"{}","order":{},"exact":{},"adaptive":{},"leavesGroup":{},)"
                        R"("conservesEnergy":{},"reversible":{},"summary":"{}","source":"{}"}})",
                        json.size() > 1 ? "," : "", m.name,
                        m.order ? fmt::to_string(*m.order) : "null", m.exact(), m.adaptive(),
                        m.linear(), m.conserves_energy, m.reversible, m.summary, m.source);
  }
  json += "]";
  return json.c_str();
}

/// The names of all shapes and the keys of their dimensions as JSON.
[[clang::export_name("shapes")]] const char* shapes() {
  static std::string json;
  json = "[";
  for (body::Shape shape : body::all_shapes()) {
    std::string keys;
    for (const body::Dimension& dimension : body::dimensions(shape)) {
      keys += fmt::format(R"({}"{}")", keys.empty() ? "" : ",", dimension.key);
    }
    json += fmt::format(R"({}{{"name":"{}","keys":[{}]}})", json.size() > 1 ? "," : "",
                        body::shape_name(shape), keys);
  }
  json += "]";
  return json.c_str();
}

/// Creates the motion of the inertia, the omega, the wheel's angular momentum, the time constant of
/// the energy loss and the attitude at t = 0 in the scratch area.
[[clang::export_name("motion_new")]] Motion* motion_new() {
  return new Motion(motion::FreeBody(matrix_at(0), vector_at(9), matrix_at(16),
                                     {.wheel = vector_at(12), .energy_loss_time = numbers[15]}));
}

[[clang::export_name("motion_free")]] void motion_free(const Motion* motion) { delete motion; }

/// Without a closed form there are no kind, flips and phase of one, but a greatest time, an upper
/// bound of the rate, and whether the body turns over.
[[clang::export_name("motion_facts")]] void motion_facts(const Motion* motion) {
  const body::PrincipalAxes& principal = motion->body.principal();
  Results results(27);
  results << motion->body.momentum() << motion->initial_energy << principal.moments
          << principal.axes << (motion->exact ? 1.0 : 0.0);
  if (!motion->exact) {
    results << motion->integrated->longest() << scene::fastest_rate(motion->body)
            << (page::turns_over(motion->body) ? 1.0 : 0.0);
    return;
  }
  const auto phase = motion->exact->phase();
  results << static_cast<double>(motion->exact->kind()) << (phase ? phase->period : 0)
          << (phase ? phase->total : 0) << (phase ? phase->dynamic : 0);
  const auto flips = motion->exact->flips();
  results << (flips ? 1.0 : 0.0);
  if (!flips) return;
  results << flips->interval << flips->first << flips->asymptotic_interval << flips->swing
          << (flips->turns_over() ? 1.0 : 0.0);
}

[[clang::export_name("motion_samples")]] void motion_samples(const Motion* motion, std::size_t n) {
  write_samples(motion->at(times_at_beginning(n)));
}

// The flips of a motion without a closed form.

[[clang::export_name("motion_flips_until")]] double motion_flips_until(const Motion* motion,
                                                                       double t) {
  return static_cast<double>(motion->integrated->flips_until(t));
}
[[clang::export_name("motion_flip")]] double motion_flip(const Motion* motion, std::size_t n) {
  return motion->integrated->flip(n).value_or(std::numeric_limits<double>::quiet_NaN());
}

[[clang::export_name("motion_integrate")]] void motion_integrate(const Motion* motion,
                                                                 std::size_t n, std::size_t method,
                                                                 double step, double tolerance,
                                                                 double most_steps) {
  const motion::StepControl control{
      .step = step, .tolerance = tolerance, .max_steps = static_cast<std::int64_t>(most_steps)};
  write_samples(
      motion::integrate(motion->body, motion::methods()[method], control, times_at_beginning(n))
          .samples);
}

/// Computes energies, energy drifts, orthogonality errors, momentum errors and distances from the
/// motion of n samples: times, attitudes and velocities. If energy is lost, its drift is the
/// difference from that of the motion.
[[clang::export_name("motion_diagnose")]] void motion_diagnose(const Motion* motion,
                                                               std::size_t n) {
  const auto diagnosed = [&](const motion::Sample& sample) {
    return motion::diagnose(motion->body, motion->initial_energy, sample);
  };
  const std::vector<motion::Sample> exact = motion->at(times_at_beginning(n));
  const bool is_lost = motion->body.energy_loss() > 0;
  std::vector<double> columns(5 * n);
  for (std::size_t i = 0; i < n; ++i) {
    const motion::Sample sample{numbers[i], matrix_at(n + 9 * i), vector_at(10 * n + 3 * i)};
    const auto found = diagnosed(sample);
    columns[i] = found.energy;
    columns[n + i] = found.energy_drift - (is_lost ? diagnosed(exact[i]).energy_drift : 0);
    columns[2 * n + i] = found.orthogonality_error;
    columns[3 * n + i] = found.momentum_error;
    columns[4 * n + i] = (sample.X - exact[i].X).norm();
  }
  std::ranges::copy(columns, numbers.begin());
}

using twrench::motion::RecordedMotion;

/// Creates the recorded motion of rows of eight doubles in the scratch area: the time, the attitude
/// as the quaternion w, x, y, z, and omega.
[[clang::export_name("recording_new")]] RecordedMotion* recording_new(std::size_t rows,
                                                                      double longest_step) {
  std::vector<RecordedMotion::Instant> instants;
  for (std::size_t i = 0; i < rows; ++i) {
    const double* row = &numbers.at(8 * i);
    instants.push_back({row[0], {row[1], row[2], row[3], row[4]}, vector_at(8 * i + 5)});
  }
  return new RecordedMotion(std::move(instants), longest_step);
}

[[clang::export_name("recording_free")]] void recording_free(const RecordedMotion* recording) {
  delete recording;
}

[[clang::export_name("recording_samples")]] void recording_samples(const RecordedMotion* recording,
                                                                   std::size_t n) {
  write_samples(recording->samples_at(times_at_beginning(n)));
}

using twrench::page::MethodRun;

[[clang::export_name("run_new")]] MethodRun* run_new(const Motion* motion, std::size_t method,
                                                     double step, double tolerance) {
  return new MethodRun(motion->body, motion::methods()[method],
                       {.step = step, .tolerance = tolerance});
}

[[clang::export_name("run_free")]] void run_free(const MethodRun* run) { delete run; }

[[clang::export_name("run_advance")]] double run_advance(MethodRun* run, double t, double steps) {
  run->advance(t, static_cast<std::size_t>(steps));
  return run->reached();
}

[[clang::export_name("run_reached")]] double run_reached(const MethodRun* run) {
  return run->reached();
}
[[clang::export_name("run_steps")]] double run_steps(const MethodRun* run) {
  return static_cast<double>(run->steps());
}
[[clang::export_name("run_evaluations")]] double run_evaluations(const MethodRun* run) {
  return static_cast<double>(run->evaluations());
}

[[clang::export_name("run_samples")]] void run_samples(MethodRun* run, std::size_t n) {
  std::vector<motion::Sample> samples;
  for (const double t : times_at_beginning(n)) samples.push_back(run->at(t));
  write_samples(samples);
}

[[clang::export_name("run_flips")]] std::size_t run_flips(const MethodRun* run) {
  const std::vector<double>& times = run->flip_times();
  scratch(times.size());
  std::ranges::copy(times, numbers.begin());
  return times.size();
}

[[clang::export_name("mass_properties")]] void mass_properties(std::size_t parts) {
  const body::MassProperties found = body::mass_properties(parts_at_beginning(parts));
  Results(25) << found.mass << found.centre_of_mass << found.inertia << found.moments << found.axes;
}

[[clang::export_name("equimomental_box")]] void equimomental_box() {
  Results(3) << std::get<body::Box>(body::equimomental_box(vector_at(0).asDiagonal()).shape).size;
}

[[clang::export_name("stability_of")]] void stability_of(std::size_t axis, double omega) {
  const motion::Stability found =
      motion::stability(vector_at(0), body::PrincipalAxes::all.at(axis), omega);
  Results(2) << static_cast<double>(found.kind) << found.rate;
}

}  // extern "C"
