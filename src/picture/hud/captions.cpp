#include "picture/hud/captions.h"

#include <algorithm>
#include <cmath>

#include "scene/phrase.h"

namespace twrench::picture::captions {
namespace {

using Eigen::Vector3d;
using scene::Phrase;

/// The extent of a part along an axis of the body, in cm from the centre of mass.
struct Extent {
  double low, high;

  double middle() const { return (low + high) / 2; }
  double half() const { return (high - low) / 2; }
  double farthest() const { return std::max(high, -low); }
};

Extent extent(const body::Part& part, int axis) {
  const Vector3d along = part.body_from_part.row(axis).transpose();
  const auto end = [&](double side) {
    return part.position[axis] + along.dot(body::support(part.shape, side * along));
  };
  return {end(-1), end(1)};
}

bool is_leg(const body::Part& part) {
  constexpr double on_axis = 1e-6;
  const Extent x = extent(part, 0), y = extent(part, 1), z = extent(part, 2);
  return x.middle() > 0 && x.half() > std::max(y.half(), z.half()) &&
         std::hypot(y.middle(), z.middle()) < on_axis * x.half();
}

bool has_leg(const scene::Body& body) {
  const std::vector<body::Part> parts = scene::visible_parts(body);
  const auto reach = [](const body::Part& part) { return extent(part, 0).farthest(); };
  const auto farthest = std::ranges::max_element(parts, {}, reach);
  const bool alone = std::ranges::all_of(parts, [&](const body::Part& part) {
    return &part == &*farthest || reach(part) < 0.999 * reach(*farthest);
  });
  return parts.size() > 1 && alone && is_leg(*farthest);
}

}  // namespace

std::string curve(const scene::Body& body, const std::string& axis, bool starts_in_space,
                  scene::Language language) {
  if (axis == "x" && has_leg(body))
    return Phrase("which way the leg points", "hvilken vei beinet peker").in(language);
  if (starts_in_space) {
    return Phrase("the body's {} axis along space {}", "legemets {}-akse langs rommets {}")
        .in(language, axis, axis);
  }
  return Phrase("the body's {} axis along its first direction",
                "legemets {}-akse langs sin første retning")
      .in(language, axis);
}

std::string longest_remark(scene::Language language) {
  return Phrase("no rotation any more", "ikke lenger en rotasjon").in(language);
}

Remarks::Remarks(const timeline::Solution& solution, scene::Language language)
    : language_(language),
      flips_(solution.flips),
      flip_times_(solution.flip_times),
      axis_(solution.body.principal().axes.col(1)),
      momentum_(solution.body.momentum()) {}

/// L swings from one end of the intermediate axis to the other. Returns 1 while it is away from the
/// axis, and less close to its turning points.
double Remarks::share_of_flip(const motion::Sample& sample) const {
  constexpr double begins = 0.95, full = 0.85;  // of L's largest component along that axis
  const Vector3d direction = (sample.X.transpose() * momentum_).stableNormalized();
  const double along = std::abs(axis_.dot(direction)) / std::sin(flips_->swing / 2);
  return std::clamp((begins - along) / (begins - full), 0.0, 1.0);
}

Remark Remarks::at(const timeline::SolutionState& state) const {
  constexpr double visible = 0.01;
  if (state.diagnostics.orthogonality_error > visible) return {longest_remark(language_)};
  const bool flips = flips_ && std::ranges::any_of(flip_times_, [&](double flip) {
                       return std::abs(state.sample.t - flip) < flips_->interval / 2;
                     });
  const double share = flips ? share_of_flip(state.sample) : 0;
  if (!(share > 0)) return {};
  return {Phrase("it turns over", "den snur").in(language_), share};
}

}  // namespace twrench::picture::captions
