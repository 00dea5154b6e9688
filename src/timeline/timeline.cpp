#include "timeline/timeline.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

#include "scene/limits.h"
#include "scene/phrase.h"
#include "scene/prediction.h"
#include "study/reference.h"

namespace twrench::timeline {
namespace {

constexpr double most_poses = scene::limits::motion_blur.high;
constexpr int whole_intervals = 1200;  // Finer than a curve across a wide panel can show.

/// Time in s of motion during which the shutter is open: half of that between two frames.
double shutter(double interval) { return 0.5 * interval; }

bool shows_path(const scene::Overlay& overlay) {
  return overlay.shows(scene::Feature::trail) || overlay.shows(scene::Feature::tip);
}

/// Time in s between two points of a trail: about 0.03 rad, but at least 50 points and at most
/// 2000.
double step_of_trail(const scene::Scene& scene, double length) {
  const double points = std::ceil(length * scene.motion.omega.norm() / 0.03);
  return length / std::clamp(points, 50.0, 2000.0);
}

/// Time in s of video between two points of a star's trail: about 0.05 rad.
double step_of_stars(const scene::Scene& scene) {
  const double rate = scene.motion.omega.norm() * scene.film.speed + std::abs(scene.camera.orbit);
  const double length = *scene.overlay.star_trail;
  return length / std::clamp(std::ceil(length * rate / 0.05), 32.0, 400.0);
}

/// Number of poses averaged in a frame that is `interval` s of motion from the next: as many as the
/// scene requests, or more if the body turns so fast that single poses would be visible, as a comb.
/// 0 without motion blur.
int blur_poses(const scene::Scene& scene, double interval) {
  const int least = scene.look.motion_blur;
  if (least == 1) return 0;
  constexpr double farthest = 3;  // pixels between two poses at the edge of the picture
  const double angle = scene.motion.omega.norm() * shutter(interval);
  const double path = angle * 0.5 * std::min(scene.film.width, scene.film.height);
  return std::max(least, static_cast<int>(std::min(std::ceil(path / farthest), most_poses)));
}

/// Nothing if the body does not turn over, or is not rigid.
std::optional<motion::ExactMotion::Flips> flips_of(const motion::FreeBody& body) {
  if (!body.is_rigid()) return std::nullopt;
  const auto flips = motion::ExactMotion(body).flips();
  return flips && flips->turns_over() ? flips : std::nullopt;
}

void add_flips(Solution& solution, double duration) {
  const motion::FreeBody& body = solution.body;
  const auto up_to = [&](double end) {
    return study::flip_times(body, *solution.method, solution.control, end);
  };
  solution.flips = flips_of(body);
  if (solution.flips) solution.flip_times = up_to(duration);
  // A body that loses energy does not turn over again and again, and a symmetric one has no
  // intermediate axis.
  if (body.energy_loss() > 0 || motion::ExactMotion::covers(body)) return;
  solution.wheel_flips = up_to(2 * duration);
  std::ranges::copy_if(solution.wheel_flips, std::back_inserter(solution.flip_times),
                       [&](double t) { return t <= duration; });
}

/// Writes numbers from 100 to a million as whole numbers.
std::string rounded(double value) {
  const double size = std::abs(value);
  const bool is_whole = size >= 100 && size < 1e6;
  return is_whole ? fmt::format("{:.0f}", value) : fmt::format("{:.3g}", value);
}

/// "middle" if one of the moments about the body's axes is smaller than that about `axis` and the
/// other greater, and likewise for the least and the greatest; "x" if two are equal.
std::string rank_of(Eigen::Index axis, const Eigen::Vector3d& moments, scene::Language language) {
  constexpr double equal = 1e-6;
  const double own = moments[axis];
  const auto differing = (moments.array() - own).abs() > equal * own;
  if (differing.count() < 2) return std::string(1, "xyz"[axis]);
  return scene::rank_name(static_cast<std::size_t>((moments.array() < own).count()), language);
}

/// "middle, 982 g cm²" for the body's axis that is within about 18 degrees of omega, with its
/// moment of inertia; otherwise omega.
std::string name_of_start(const Eigen::Vector3d& omega, const Eigen::Matrix3d& inertia,
                          scene::Language language) {
  Eigen::Index axis = 0;
  constexpr double near = 0.95;
  if (omega.isZero(0.0) || omega.cwiseAbs().maxCoeff(&axis) < near * omega.norm()) {
    return fmt::format("({:.4g}, {:.4g}, {:.4g}) rad/s", omega.x(), omega.y(), omega.z());
  }
  return fmt::format("{}, {} g cm²", rank_of(axis, inertia.diagonal(), language),
                     rounded(inertia(axis, axis)));
}

/// "h 300 g cm²/s" for a wheel along a body axis, because a legend is narrow; "no wheel".
std::string name_of_wheel(const Eigen::Vector3d& wheel, scene::Language language) {
  if (wheel.isZero(0.0)) return scene::Phrase("no wheel", "uten hjul").in(language);
  Eigen::Index axis = 0;
  if (wheel.cwiseAbs().maxCoeff(&axis) == wheel.norm()) {
    return fmt::format("h {} g cm²/s", rounded(wheel[axis]));
  }
  return fmt::format("h ({}, {}, {}) g cm²/s", rounded(wheel.x()), rounded(wheel.y()),
                     rounded(wheel.z()));
}

/// The times at which curves are drawn.
std::vector<double> whole_times(double duration) {
  std::vector<double> times;
  for (int i = 0; i <= whole_intervals; ++i) times.push_back(duration * i / whole_intervals);
  return times;
}

Solution recorded_solution(const scene::Scene& scene, const motion::StepControl& control,
                           const motion::FreeBody& body) {
  const auto& recording = scene.motion.recording;
  Solution solution{&motion::find_method(scene.motion.method),
                    control,
                    body,
                    motion::energy(body.inertia(), recording->motion.instants().front().omega),
                    recording->motion.samples_at(whole_times(scene.motion.duration)),
                    {},
                    recording->flip_times,
                    recording->flip_times,
                    scene::recorded_name,
                    recording};
  return solution;
}

Solution solution_of(const scene::Scene& scene, const motion::StepControl& control,
                     const std::string& name, const std::string& method,
                     const motion::FreeBody& body) {
  Solution solution{&motion::find_method(method), control, body, 0.0, {}, {}, {}, {}, name};
  solution.initial_energy = motion::energy(solution.body.inertia(), solution.body.omega());
  solution.whole = solution.samples_at(whole_times(scene.motion.duration));
  add_flips(solution, scene.motion.duration);
  return solution;
}

/// Returns the name of a motion among those shown side by side; the method if there are no others.
std::string name_of(const scene::Scene& scene, const motion::FreeBody& body) {
  if (!scene.overlay.compare_omega.empty()) {
    return name_of_start(body.omega(), body.inertia(), scene.language);
  }
  if (!scene.overlay.compare_wheel.empty()) {
    return name_of_wheel(body.interior().wheel, scene.language);
  }
  return scene.motion.method;
}

/// One solution per method, or of a recording, or per initial angular velocity or wheel.
std::vector<Solution> solutions_of(const scene::Scene& scene, const std::atomic<bool>* stop) {
  motion::StepControl control = scene.motion.control;
  control.stop = stop;
  const std::vector<motion::FreeBody> bodies = scene::shown_bodies(scene);
  std::vector<Solution> solutions;
  if (scene.motion.recording) {
    solutions.push_back(recorded_solution(scene, control, bodies[0]));
  }
  for (const std::string& method : scene.overlay.compare) {
    if (method == scene::recorded_name) continue;
    solutions.push_back(solution_of(scene, control, method, method, bodies[0]));
  }
  if (!solutions.empty()) return solutions;
  for (const motion::FreeBody& body : bodies) {
    solutions.push_back(
        solution_of(scene, control, name_of(scene, body), scene.motion.method, body));
  }
  return solutions;
}

std::optional<double> next_flip(const Solution& solution, double t) {
  if (!solution.flips) {
    const auto next = std::ranges::upper_bound(solution.wheel_flips, t);
    return next == solution.wheel_flips.end() ? std::nullopt : std::optional(*next);
  }
  const double interval = solution.flips->interval, first = solution.flips->first;
  if (t < first) return std::isfinite(first) ? std::optional(first) : std::nullopt;
  if (!std::isfinite(interval)) return std::nullopt;
  return first + interval * (std::floor((t - first) / interval) + 1);
}

}  // namespace

double trail_length(const scene::Scene& scene) {
  const double speed = scene.motion.omega.norm();
  return scene.overlay.trail_length.value_or(speed > 0 ? 12 / speed : scene.motion.duration);
}

std::vector<FrameTime> frame_times(const scene::Film& film, const std::vector<int>& frames) {
  std::vector<FrameTime> times;
  times.reserve(frames.size());
  for (const int frame : frames) {
    times.push_back({frame, frame / film.fps, film.time_of(frame), film.speed / film.fps});
  }
  return times;
}

Timeline::Timeline(const scene::Scene& scene, std::span<const FrameTime> frames,
                   const std::atomic<bool>* stop, const Clock& clock)
    : scene_(scene),
      frames_(frames.begin(), frames.end()),
      trail_length_(trail_length(scene)),
      grid_step_(step_of_trail(scene, trail_length_)),
      clock_(clock ? clock : [speed = scene.film.speed](double time) { return time * speed; }) {
  for (const FrameTime& frame : frames_) {
    const std::size_t before = blur_ends_.empty() ? 0 : blur_ends_.back();
    blur_ends_.push_back(before + static_cast<std::size_t>(blur_poses(scene, frame.interval)));
  }
  if (shows_path(scene.overlay)) {
    std::int64_t next = 0;
    for (const auto& [frame, video_time, t, interval] : frames_) {
      const auto oldest = static_cast<std::int64_t>(std::ceil((t - trail_length_) / grid_step_));
      for (next = std::max(next, oldest); static_cast<double>(next) * grid_step_ < t; ++next) {
        grid_numbers_.push_back(next);
      }
    }
  }
  if (scene.overlay.star_trail.value_or(0) > 0) add_star_times();
  solutions_ = solutions_of(scene, stop);
  for (const Solution& solution : solutions_) records_.push_back(record(solution));
}

/// Consecutive frames share the times.
void Timeline::add_star_times() {
  const double step = step_of_stars(scene_);
  double next = -std::numeric_limits<double>::infinity();
  for (const FrameTime& frame : frames_) {
    next = std::max(next, std::ceil((frame.video_time - *scene_.overlay.star_trail) / step));
    for (; next * step < frame.video_time; ++next) star_times_.push_back(next * step);
  }
}

/// Integrates once, because the sample at a time does not depend on which others are requested.
Timeline::Record Timeline::record(const Solution& solution) const {
  std::vector<double> times;
  for (const FrameTime& frame : frames_) times.push_back(frame.t);
  for (const FrameTime& frame : frames_) {
    const int count = blur_poses(scene_, frame.interval);
    for (int i = 0; i < count; ++i) {
      times.push_back(frame.t + shutter(frame.interval) * ((i + 0.5) / count - 0.5));
    }
  }
  for (const std::int64_t number : grid_numbers_) {
    times.push_back(static_cast<double>(number) * grid_step_);
  }
  for (const double time : star_times_) times.push_back(std::max(0.0, clock_(time)));
  const std::vector<motion::Sample> samples = solution.samples_at(times);
  const auto blur = samples.begin() + std::ssize(frames_);
  const auto stars = samples.end() - std::ssize(star_times_);
  const auto grid = stars - std::ssize(grid_numbers_);
  return {{samples.begin(), blur}, {blur, grid}, {grid, stars}, {stars, samples.end()}};
}

std::vector<motion::Sample> Timeline::trail(const Record& record, std::size_t index) const {
  const motion::Sample& now = record.frames[index];
  const auto time = [](const motion::Sample& sample) { return sample.t; };
  const auto first = std::ranges::lower_bound(record.grid, now.t - trail_length_, {}, time);
  const auto last = std::ranges::lower_bound(record.grid, now.t, {}, time);
  std::vector<motion::Sample> trail(first, last);
  trail.push_back(now);
  return trail;
}

void Timeline::add_stars(FrameState& state) const {
  const auto first =
      std::ranges::lower_bound(star_times_, state.video_time - *scene_.overlay.star_trail);
  const auto last = std::ranges::lower_bound(star_times_, state.video_time);
  state.star_times.assign(first, last);
  state.star_times.push_back(state.video_time);
  for (std::size_t i = 0; i < records_.size(); ++i) {
    const auto& stars = records_[i].stars;
    std::vector<motion::Sample>& samples = state.solutions[i].stars;
    samples.assign(stars.begin() + (first - star_times_.begin()),
                   stars.begin() + (last - star_times_.begin()));
    samples.push_back(state.solutions[i].sample);
  }
}

std::vector<motion::Sample> Solution::samples_at(std::span<const double> times) const {
  return recording ? recording->motion.samples_at(times)
                   : motion::integrate(body, *method, control, times).samples;
}

double SolutionState::trail_age(const motion::Sample& of_trail, double trail_length) const {
  return std::clamp((sample.t - of_trail.t) / trail_length, 0.0, 1.0);
}

FlipsSoFar Timeline::flips(std::size_t index) const {
  const auto flipping = std::ranges::find_if(
      solutions_, [](const Solution& solution) { return !solution.flip_times.empty(); });
  if (flipping == solutions_.end()) return {};
  const std::vector<double>& times = flipping->flip_times;
  const auto next = std::ranges::upper_bound(times, frames_[index].t);
  if (next == times.begin()) return {};
  return {static_cast<int>(next - times.begin()), *std::prev(next)};
}

FrameState Timeline::frame_state(std::size_t index) const {
  FrameState state{frames_[index].frame, frames_[index].video_time, 1, 1, {}};
  for (std::size_t i = 0; i < solutions_.size(); ++i) {
    const Solution& solution = solutions_[i];
    const Record& record = records_[i];
    SolutionState instant{
        record.frames[index],
        motion::diagnose(solution.body, solution.initial_energy, record.frames[index]),
        0,
        next_flip(solution, record.frames[index].t),
        {},
        {},
        {}};
    instant.flips =
        static_cast<std::size_t>(std::ranges::upper_bound(solution.flip_times, instant.sample.t) -
                                 solution.flip_times.begin());
    if (shows_path(scene_.overlay)) instant.trail = trail(record, index);
    const std::size_t first = index == 0 ? 0 : blur_ends_[index - 1];
    for (std::size_t k = first; k < blur_ends_[index]; ++k) {
      instant.blur.push_back(record.blur[k]);
    }
    state.solutions.push_back(std::move(instant));
  }
  if (scene_.overlay.star_trail.value_or(0) > 0) add_stars(state);
  return state;
}

}  // namespace twrench::timeline
