#include "timeline/timeline.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "study/flip_search.h"

namespace twrench {
namespace {

constexpr int whole_intervals = 1200;  // Finer than a curve across a wide panel can show.

/// Time in s between two points of a trail: about 0.03 rad, but at least 50 points and at most
/// 2000.
double step_of_trail(const Scene& scene, double length) {
  const double points = std::ceil(length * scene.motion.omega.norm() / 0.03);
  return length / std::clamp(points, 50.0, 2000.0);
}

/// Nothing if the intermediate axis does not swing past the plane normal to L far enough to count
/// as turning over.
std::optional<ExactMotion::Flips> flips_of(const FreeBody& body) {
  const auto flips = ExactMotion(body).flips();
  if (!flips || flips->swing < std::numbers::pi / 2) return std::nullopt;
  return flips;
}

std::vector<double> seen_flips(const Take& take, double duration) {
  if (!take.flips) return {};
  if (take.method->exact()) {
    return ExactMotion(take.body).flip_times(duration);
  }
  FlipSearch search(take.body, *take.method);
  visit_steps(take.body, *take.method, take.control, duration,
              [&](const OwnStep& step) { search.visit(step); });
  return search.times();
}

Take take_of(const Scene& scene, const std::string& method) {
  Take take{&find_method(method),
            scene.motion.control,
            FreeBody(mass_properties(scene.body).inertia, scene.motion.omega),
            0.0,
            {},
            {},
            {}};
  take.initial_energy = energy(take.body.inertia(), take.body.omega());
  std::vector<double> times;
  for (int i = 0; i <= whole_intervals; ++i) {
    times.push_back(scene.motion.duration * i / whole_intervals);
  }
  take.whole = trajectory(take.body, *take.method, take.control, times).samples;
  take.flips = flips_of(take.body);
  take.flip_times = seen_flips(take, scene.motion.duration);
  return take;
}

std::optional<double> next_flip(const Take& take, double t) {
  if (!take.flips) return std::nullopt;
  const auto& [interval, first, asymptotic, swing] = *take.flips;
  if (t < first) return std::isfinite(first) ? std::optional(first) : std::nullopt;
  if (!std::isfinite(interval)) return std::nullopt;
  return first + interval * (std::floor((t - first) / interval) + 1);
}

}  // namespace

double trail_length(const Scene& scene) {
  const double speed = scene.motion.omega.norm();
  return scene.overlay.trail_length.value_or(speed > 0 ? 12 / speed : scene.motion.duration);
}

Timeline::Timeline(const Scene& scene, std::vector<int> frames)
    : scene_(scene),
      frames_(std::move(frames)),
      trail_length_(trail_length(scene)),
      grid_step_(step_of_trail(scene, trail_length_)) {
  if (scene.overlay.shows(Feature::trail)) {
    std::int64_t next = 0;
    for (const int frame : frames_) {
      const double t = scene.film.time_of(frame);
      const auto oldest = static_cast<std::int64_t>(std::ceil((t - trail_length_) / grid_step_));
      for (next = std::max(next, oldest); static_cast<double>(next) * grid_step_ < t; ++next) {
        grid_numbers_.push_back(next);
      }
    }
  }
  const auto methods =
      scene.overlay.compare.empty() ? std::vector{scene.motion.method} : scene.overlay.compare;
  for (const std::string& method : methods) {
    takes_.push_back(take_of(scene, method));
    records_.push_back(record(takes_.back()));
  }
}

Timeline::Record Timeline::record(const Take& take) const {
  const auto sampled = [&](const std::vector<double>& times) {
    return trajectory(take.body, *take.method, take.control, times).samples;
  };
  std::vector<double> own, blurred, grid;
  const int count = scene_.look.motion_blur;
  const double open = 0.5 * scene_.film.speed / scene_.film.fps;  // half the frame interval
  for (const int frame : frames_) {
    own.push_back(scene_.film.time_of(frame));
    for (int i = 0; count > 1 && i < count; ++i) {
      blurred.push_back(own.back() + open * ((i + 0.5) / count - 0.5));
    }
  }
  for (const std::int64_t number : grid_numbers_) {
    grid.push_back(static_cast<double>(number) * grid_step_);
  }
  return {sampled(own), sampled(blurred), sampled(grid)};
}

std::vector<Sample> Timeline::trail(const Record& record, std::size_t index) const {
  const Sample& now = record.frames[index];
  const auto time = [](const Sample& sample) { return sample.t; };
  const auto first = std::ranges::lower_bound(record.grid, now.t - trail_length_, {}, time);
  const auto last = std::ranges::lower_bound(record.grid, now.t, {}, time);
  std::vector<Sample> trail(first, last);
  trail.push_back(now);
  return trail;
}

Moment Timeline::moment(std::size_t index) const {
  Moment moment{frames_[index], frames_[index] / scene_.film.fps, {}};
  for (std::size_t i = 0; i < takes_.size(); ++i) {
    const Take& take = takes_[i];
    const Record& record = records_[i];
    Instant instant{record.frames[index],
                    diagnose(take.body, take.initial_energy, record.frames[index]),
                    0,
                    next_flip(take, record.frames[index].t),
                    {},
                    {}};
    instant.flips = static_cast<std::size_t>(
        std::ranges::upper_bound(take.flip_times, instant.sample.t) - take.flip_times.begin());
    if (scene_.overlay.shows(Feature::trail)) instant.trail = trail(record, index);
    const auto count = static_cast<std::size_t>(scene_.look.motion_blur);
    for (std::size_t k = 0; count > 1 && k < count; ++k) {
      instant.blur.push_back(record.blur[index * count + k].X);
    }
    moment.instants.push_back(std::move(instant));
  }
  return moment;
}

}  // namespace twrench
